// SPDX-License-Identifier: MIT
#include "core/evaluation/ReaderAgreement.h"

#include <algorithm>

#include "core/common/Error.h"

namespace fodscope {
namespace {

struct Reading {
    std::set<std::string> labels;
    UtcTime time;
};

/// A photo of any of the sessions.
struct ReadPhoto {
    std::map<std::string, Reading> readings;
    std::optional<std::set<std::string>> actual;
};

using PhotoKey = std::pair<std::string, std::string>;

std::set<std::string> namesIn(const Decision& decision) {
    std::set<std::string> names;
    for (const PhotoLabel& label : decision.labels)
        names.insert(label.label);
    return names;
}

std::map<PhotoKey, ReadPhoto> readPhotos(std::span<const ReadSession> sessions) {
    std::map<PhotoKey, ReadPhoto> photos;
    for (const ReadSession& session : sessions) {
        for (const std::string& photoId : session.photoIds) {
            ReadPhoto& photo = photos[{session.id, photoId}];
            if (session.actual && session.actual->contains(photoId)) photo.actual = session.actual->at(photoId);
            for (const Decision* decision : countingDecisions(session.decisions, photoId)) {
                Reading& reading = photo.readings[decision->labeller];
                if (!reading.labels.empty() && decision->time < reading.time) continue;
                reading = {namesIn(*decision), decision->time};
            }
        }
    }
    return photos;
}

std::set<std::string> namesOfReaders(const std::map<PhotoKey, ReadPhoto>& photos) {
    std::set<std::string> names;
    for (const auto& [key, photo] : photos)
        for (const auto& [name, reading] : photo.readings)
            names.insert(name);
    return names;
}

/// Several labels on one photo are a category of their own: "drill + hammer".
std::string categoryOf(const std::set<std::string>& labels) {
    std::string name;
    for (const std::string& label : labels)
        name += (name.empty() ? "" : " + ") + label;
    return name;
}

/// Every label that could be given, and every combination that was.
std::vector<std::string> categoriesOf(std::span<const ReadSession> sessions,
                                      const std::map<PhotoKey, ReadPhoto>& photos,
                                      const std::set<std::string>& readers) {
    std::set<std::string> names;
    for (const ReadSession& session : sessions)
        for (const Label& label : session.labelSet.labels)
            names.insert(label.name);
    for (const auto& [key, photo] : photos)
        for (const auto& [reader, reading] : photo.readings)
            if (readers.contains(reader)) names.insert(categoryOf(reading.labels));
    return {names.begin(), names.end()};
}

std::vector<ItemRatings> ratingsOf(const std::map<PhotoKey, ReadPhoto>& photos, const std::set<std::string>& readers,
                                   const std::vector<std::string>& categories) {
    std::vector<ItemRatings> items;
    for (const auto& [key, photo] : photos) {
        ItemRatings item;
        for (const std::string& reader : readers) {
            const auto found = photo.readings.find(reader);
            if (found == photo.readings.end()) {
                item.emplace_back();
                continue;
            }
            const auto at = std::ranges::lower_bound(categories, categoryOf(found->second.labels));
            item.emplace_back(static_cast<std::size_t>(at - categories.begin()));
        }
        items.push_back(std::move(item));
    }
    return items;
}

ReaderFigures figuresOf(const std::string& reader, const std::map<PhotoKey, ReadPhoto>& photos,
                        std::vector<ConfusionEntry>& all) {
    ReaderFigures figures;
    figures.name = reader;
    std::vector<ConfusionEntry> own;
    for (const auto& [key, photo] : photos) {
        const auto found = photo.readings.find(reader);
        if (found == photo.readings.end()) continue;
        ++figures.photos;
        if (!photo.actual) continue;
        const auto entries = confusionEntries(found->second.labels, *photo.actual);
        own.insert(own.end(), entries.begin(), entries.end());
    }
    figures.accuracy = confusionMatrix(own).accuracy();
    all.insert(all.end(), own.begin(), own.end());
    return figures;
}

}  // namespace

ReaderAgreement readerAgreement(std::span<const ReadSession> sessions,
                                const std::function<bool(const std::string&)>& isSimulated) {
    const std::map<PhotoKey, ReadPhoto> photos = readPhotos(sessions);
    std::set<std::string> readers = namesOfReaders(photos);
    ReaderAgreement result;
    const bool hasPerson = std::ranges::any_of(readers, [&](const std::string& name) { return !isSimulated(name); });
    if (hasPerson) {
        std::ranges::copy_if(readers, std::back_inserter(result.leftOut), isSimulated);
        std::erase_if(readers, isSimulated);
    }
    if (readers.empty())
        throw Error("agreement", "nobody has labelled a photo in these sessions", "label their photos first");
    std::vector<ConfusionEntry> entries;
    for (const std::string& reader : readers)
        result.readers.push_back(figuresOf(reader, photos, entries));
    if (!entries.empty()) result.confusion = confusionMatrix(entries);
    result.photos = photos.size();
    result.photosWithoutReader = static_cast<std::size_t>(std::ranges::count_if(photos, [&](const auto& entry) {
        return std::ranges::none_of(readers,
                                    [&](const std::string& reader) { return entry.second.readings.contains(reader); });
    }));
    const std::vector<std::string> categories = categoriesOf(sessions, photos, readers);
    result.categories = categories.size();
    result.statistics = agreementOf(ratingsOf(photos, readers, categories), categories.size());
    return result;
}

}  // namespace fodscope
