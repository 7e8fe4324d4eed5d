// SPDX-License-Identifier: MIT
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <opencv2/imgcodecs.hpp>

#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/planning/OccupancyGrid.h"

namespace fodscope {
namespace {

enum class Mode { Trinary, Scale, Raw };

/// The YAML file of a map_server pair.
struct MapServerHeader {
    std::filesystem::path image;
    double resolution_m = 0.0;
    Pose2 origin_map;
    bool negate = false;
    double occupiedThreshold = 0.0;
    double freeThreshold = 0.0;
    Mode mode = Mode::Trinary;
};

Error outOfRange(const std::string& file, const std::string& key, const std::string& remedy) {
    return Error(file, "the value of '" + key + "' is out of range", remedy);
}

YAML::Node loadYaml(const std::filesystem::path& yamlFile) {
    const std::string text = readTextFile(yamlFile);
    try {
        YAML::Node root = YAML::Load(text);
        if (root.IsMap()) return root;
    } catch (const YAML::Exception& problem) {
        throw Error(yamlFile.string(), std::string("is not valid YAML (") + problem.what() + ")",
                    "give the YAML file of a map_server map");
    }
    throw Error(yamlFile.string(), "is not a map_server file (no keys)", "give the YAML file of a map_server map");
}

template <typename Value>
Value valueOf(const YAML::Node& root, const std::string& file, const std::string& key) {
    const YAML::Node node = root[key];
    if (!node) throw Error(file, "the key '" + key + "' is missing", "add it as map_server writes it");
    try {
        return node.as<Value>();
    } catch (const YAML::Exception&) {
        throw Error(file, "the value of '" + key + "' is of the wrong kind", "write it as map_server does");
    }
}

bool negateOf(const YAML::Node& root, const std::string& file) {
    const auto text = valueOf<std::string>(root, file, "negate");
    if (text == "0" || text == "false") return false;
    if (text == "1" || text == "true") return true;
    throw outOfRange(file, "negate", "write 0 or 1");
}

Mode modeOf(const YAML::Node& root, const std::string& file) {
    if (!root["mode"]) return Mode::Trinary;
    const auto text = valueOf<std::string>(root, file, "mode");
    if (text == "trinary") return Mode::Trinary;
    if (text == "scale") return Mode::Scale;
    if (text == "raw") return Mode::Raw;
    throw outOfRange(file, "mode", "write trinary, scale or raw");
}

MapServerHeader readHeader(const std::filesystem::path& yamlFile) {
    const std::string file = yamlFile.string();
    const YAML::Node root = loadYaml(yamlFile);
    MapServerHeader header;
    header.image = valueOf<std::string>(root, file, "image");
    if (header.image.empty()) throw outOfRange(file, "image", "name the PGM or PNG file of the map");
    if (header.image.is_relative()) header.image = yamlFile.parent_path() / header.image;
    header.resolution_m = valueOf<double>(root, file, "resolution");
    if (!(header.resolution_m > 0.0) || !std::isfinite(header.resolution_m)) {
        throw outOfRange(file, "resolution", "write the metres per pixel, over 0");
    }
    const auto origin = valueOf<std::vector<double>>(root, file, "origin");
    const auto finite = [](double value) { return std::isfinite(value); };
    if (origin.size() != 3 || !std::all_of(origin.begin(), origin.end(), finite)) {
        throw outOfRange(file, "origin", "write three numbers: x and y in metres, yaw in radians");
    }
    header.origin_map = {origin[0], origin[1], origin[2]};
    header.negate = negateOf(root, file);
    header.occupiedThreshold = valueOf<double>(root, file, "occupied_thresh");
    header.freeThreshold = valueOf<double>(root, file, "free_thresh");
    if (!(header.freeThreshold >= 0.0 && header.freeThreshold <= header.occupiedThreshold &&
          header.occupiedThreshold <= 1.0)) {
        throw outOfRange(file, "free_thresh", "write thresholds from 0 to 1, free_thresh not over occupied_thresh");
    }
    header.mode = modeOf(root, file);
    return header;
}

struct ImageSize {
    double width = 0.0;
    double height = 0.0;
};

ImageSize pngSize(const std::vector<std::byte>& bytes) {
    const auto bigEndian = [&](std::size_t at) {
        double value = 0.0;
        for (std::size_t i = at; i < at + 4; ++i)
            value = value * 256.0 + std::to_integer<int>(bytes[i]);
        return value;
    };
    return {bigEndian(16), bigEndian(20)};
}

/// Width and height of a portable any-map, which follow the signature and may have comments between them.
ImageSize pnmSize(const std::string& header) {
    double numbers[2] = {0.0, 0.0};
    std::size_t at = 2;
    for (double& number : numbers) {
        while (at < header.size() && (std::isspace(static_cast<unsigned char>(header[at])) || header[at] == '#')) {
            if (header[at] == '#') at = std::min(header.find('\n', at), header.size() - 1);
            ++at;
        }
        while (at < header.size() && header[at] >= '0' && header[at] <= '9')
            number = number * 10.0 + (header[at++] - '0');
    }
    return {numbers[0], numbers[1]};
}

/// The size is known before anything is allocated for it.
void requireSaneSize(const std::filesystem::path& image, const std::vector<std::byte>& bytes) {
    const std::string start(reinterpret_cast<const char*>(bytes.data()), std::min<std::size_t>(bytes.size(), 4096));
    const bool isPng = start.size() >= 24 && start.compare(0, 8, "\x89PNG\r\n\x1a\n") == 0;
    const bool isPnm = start.size() >= 8 && start[0] == 'P' && (start[1] == '2' || start[1] == '5');
    if (!isPng && !isPnm) {
        throw Error(image.string(), "is neither a PGM nor a PNG image", "convert the map's image to one of them");
    }
    const ImageSize size = isPng ? pngSize(bytes) : pnmSize(start);
    const double pixels = size.width * size.height;
    if (!(pixels >= 1.0)) throw Error(image.string(), "the image has no pixels", "give the image of the map");
    if (pixels > kGreatestCellCount) {
        throw Error(image.string(), "the image has more than 25 million pixels", "give a coarser map");
    }
    const std::string end(reinterpret_cast<const char*>(bytes.data()) + bytes.size() - 8, 8);
    const bool isComplete =
        isPng ? end.compare(0, 4, "IEND") == 0 : start[1] == '2' || pixels <= static_cast<double>(bytes.size());
    if (!isComplete) {
        throw Error(image.string(), "the image is cut off", "copy the file anew");
    }
}

/// @return 8 bits a channel, with as many channels as the file has
cv::Mat readImage(const std::filesystem::path& image) {
    const std::vector<std::byte> bytes = readFile(image);
    requireSaneSize(image, bytes);
    cv::Mat pixels;
    try {
        const cv::Mat raw(1, static_cast<int>(bytes.size()), CV_8U, const_cast<std::byte*>(bytes.data()));
        pixels = cv::imdecode(raw, cv::IMREAD_UNCHANGED);
    } catch (const cv::Exception&) {
        pixels.release();
    }
    if (pixels.empty()) {
        throw Error(image.string(), "the image cannot be decoded (damaged or cut off)", "copy the file anew");
    }
    if (pixels.depth() == CV_16U) pixels.convertTo(pixels, CV_8U, 1.0 / 257.0);
    return pixels;
}

/// map_server's mean over the channels: transparency counts among them in trinary mode only.
double meanOfPixel(const std::uint8_t* pixel, int channels, Mode mode) {
    const int counted = mode == Mode::Trinary || channels == 1 ? channels : channels - 1;
    double sum = 0.0;
    for (int channel = 0; channel < counted; ++channel)
        sum += pixel[channel];
    return sum / counted;
}

Cell cellOf(double brightness, const MapServerHeader& header) {
    if (header.negate) brightness = 255.0 - brightness;
    if (header.mode == Mode::Raw && brightness > 100.0) return Cell::Unknown;
    const double occupancy = header.mode == Mode::Raw ? brightness / 100.0 : (255.0 - brightness) / 255.0;
    if (occupancy > header.occupiedThreshold) return Cell::Occupied;
    if (occupancy < header.freeThreshold) return Cell::Free;
    return Cell::Unknown;
}

std::string shortest(double value) {
    char text[32];
    const auto end = std::to_chars(std::begin(text), std::end(text), value).ptr;
    return std::string(text, end);
}

}  // namespace

OccupancyGrid readMapServerGrid(const std::filesystem::path& yamlFile) {
    const MapServerHeader header = readHeader(yamlFile);
    const cv::Mat pixels = readImage(header.image);
    const int channels = pixels.channels();
    OccupancyGrid grid;
    grid.width = pixels.cols;
    grid.height = pixels.rows;
    grid.resolution_m = header.resolution_m;
    grid.origin_map = header.origin_map;
    grid.cells.resize(static_cast<std::size_t>(pixels.cols) * static_cast<std::size_t>(pixels.rows));
    for (int row = 0; row < grid.height; ++row) {
        // Images begin at the top, grids at the bottom.
        const std::uint8_t* line = pixels.ptr<std::uint8_t>(grid.height - 1 - row);
        for (int column = 0; column < grid.width; ++column) {
            const double brightness = meanOfPixel(line + column * channels, channels, header.mode);
            grid.cells[grid.offset({column, row})] = cellOf(brightness, header);
        }
    }
    return grid;
}

void writeMapServerGrid(const std::filesystem::path& yamlFile, const OccupancyGrid& grid) {
    requireUsable(grid);
    std::filesystem::path image = yamlFile;
    image.replace_extension(".pgm");
    std::string pgm = "P5\n" + std::to_string(grid.width) + " " + std::to_string(grid.height) + "\n255\n";
    for (int row = grid.height - 1; row >= 0; --row) {
        for (int column = 0; column < grid.width; ++column) {
            const Cell cell = grid.at({column, row});
            pgm += static_cast<char>(cell == Cell::Free ? 254 : cell == Cell::Occupied ? 0 : 205);
        }
    }
    const Pose2& origin = grid.origin_map;
    YAML::Emitter name;
    name << image.filename().string();
    const std::string yaml = std::string("image: ") + name.c_str() + "\nresolution: " + shortest(grid.resolution_m) +
                             "\norigin: [" + shortest(origin.x_m) + ", " + shortest(origin.y_m) + ", " +
                             shortest(origin.yaw_rad) + "]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
    writeFile(image, pgm);
    writeFile(yamlFile, yaml);
}

}  // namespace fodscope
