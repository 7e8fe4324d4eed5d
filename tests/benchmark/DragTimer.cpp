// SPDX-License-Identifier: MIT
// Times what an operator sees who drags the threshold in the window: from a move of the slider until candidates, table
// and 3D view show it, on a map of 200 thousand voxels. Needs a screen, or xvfb-run. Prints one line of JSON,
// milliseconds: the wait of each move, the part of it for which the window was busy, and the longest time for which it
// could not have answered anything else; the same for letting the slider go, which keeps the settings in the session.
#include <CLI/CLI.hpp>
#include <QApplication>
#include <QSlider>
#include <QTemporaryDir>
#include <QThread>
#include <chrono>
#include <iostream>
#include <nlohmann/json.hpp>

#include "core/common/Error.h"
#include "core/detection/LiveCandidates.h"
#include "storage/SessionFile.h"
#include "tests/benchmark/BoxRoom.h"
#include "tests/benchmark/DragPath.h"
#include "ui/session/InspectionController.h"
#include "ui/theme/Theme.h"
#include "ui/widgets/ValueSlider.h"
#include "ui/window/MainWindow.h"

namespace fodscope {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// Nobody asks for a file here.
class NoFiles : public FileDialogs {
  public:
    QString openFile(QWidget*, const QString&, const QString&) override { return {}; }
    QStringList openFiles(QWidget*, const QString&, const QString&) override { return {}; }
    QString saveFile(QWidget*, const QString&, const QString&, const QString&) override { return {}; }
    QString chooseFolder(QWidget*, const QString&, const QString&) override { return {}; }
};

struct Wait {
    double whole_ms = 0.0;
    double busy_ms = 0.0;
    double longest_ms = 0.0;
};

/// Lets the window work until `done`, and what it has to draw then is drawn.
template <typename Done>
Wait waitUntil(const char* what, const Done& done) {
    constexpr double patience_ms = 60e3;
    const auto begin = Clock::now();
    Wait wait;
    int rounds = 0;
    while (rounds < 3) {
        if (millisecondsSince(begin) > patience_ms)
            throw Error("window", std::string("never came to ") + what, "run it again with fewer moves");
        if (done()) ++rounds;
        const auto turn = Clock::now();
        QApplication::processEvents();
        const double spent_ms = millisecondsSince(turn);
        wait.busy_ms += spent_ms;
        wait.longest_ms = std::max(wait.longest_ms, spent_ms);
        if (rounds == 0) QThread::usleep(100);
    }
    wait.whole_ms = millisecondsSince(begin);
    return wait;
}

nlohmann::json summary(const std::vector<Wait>& waits) {
    nlohmann::json result{{"moves", waits.size()}};
    for (const auto& [name, part] :
         {std::pair{"wait", &Wait::whole_ms}, {"busy", &Wait::busy_ms}, {"longest", &Wait::longest_ms}}) {
        std::vector<double> values;
        for (const Wait& wait : waits)
            values.push_back(wait.*part);
        result[name] = {{"median_ms", quantileOf(values, 0.5)},
                        {"p95_ms", quantileOf(values, 0.95)},
                        {"greatest_ms", quantileOf(values, 1.0)}};
    }
    return result;
}

void writeSession(const std::string& file, const std::shared_ptr<const DiscrepancyField>& field) {
    const auto session = SessionFile::create(file, newInspectionHeader());
    InspectionState state;
    Inspection inspection(state, *session);
    auto reference = std::make_shared<ReferenceMap>();
    reference->points = field->points;
    reference->covariance.assign(field->size(), 1e-4 * Eigen::Matrix3d::Identity());
    reference->occupancy.assign(field->size(), 1);
    reference->sampleCount.assign(field->size(), 1);
    reference->untrained.assign(field->size(), 0);
    inspection.setReference({"reference.ply", std::string(64, '0'), field->size()}, reference);
    inspection.setMap({"map.pcd", std::string(64, '1'), field->size()});
    const Parameters parameters = presetParameters("paper-physical");
    DetectionResult detection;
    detection.registration.quality = RegistrationQuality::Given;
    detection.field = field;
    Progress progress;
    detection.candidates = std::make_shared<CandidateSet>(
        findCandidates(*field, parameters.candidates, 0.02, 0.0, Transform::Identity(), progress));
    inspection.adoptDetection(parameters, detection);
}

nlohmann::json drag(std::size_t voxels, std::size_t moves, std::size_t fewest, std::size_t most) {
    const QTemporaryDir folder;
    const auto field = drawnField(boxRoom(voxels, 6), 7);
    writeSession(folder.filePath("drag.fodscope").toStdString(), field);
    NoFiles files;
    InspectionController controller;
    MainWindow window(controller, files);
    window.resize(1366, 768);
    window.show();
    controller.openSession(folder.filePath("drag.fodscope"));
    waitUntil("an open session", [&] { return controller.isOpen() && !controller.tasks().isBusy(); });
    window.showStep(Step::Candidates);
    for (int i = 0; i < 5; ++i)
        waitUntil("rest", [] { return true; });

    auto* threshold = window.findChild<ValueSlider*>(QStringLiteral("slider.threshold"));
    auto* slider = threshold->findChild<QSlider*>();
    int shown = 0;
    QObject::connect(&controller, &InspectionController::candidatesChanged, &controller, [&] { ++shown; });
    std::vector<Wait> dragged;
    std::vector<double> candidates;
    slider->setSliderDown(true);
    for (const CandidateSettings& settings : dragPath(*field, 3 * moves, fewest, most, 8)) {
        const int position =
            std::min(slider->maximum(), static_cast<int>(std::lround(settings.threshold / 12.0 * slider->maximum())));
        if (position == slider->value() || dragged.size() >= moves) continue;
        shown = 0;
        slider->setValue(position);
        dragged.push_back(waitUntil("candidates of a moved slider", [&] { return shown > 0; }));
        candidates.push_back(static_cast<double>(controller.shownCandidates()->candidates.size()));
    }
    std::vector<Wait> released;
    for (int i = 0; i < 10; ++i) {
        slider->setSliderDown(true);
        slider->setValue(100 + i);
        waitUntil("a preview", [&] { return controller.isPreviewing(); });
        slider->setSliderDown(false);
        released.push_back(waitUntil("settings that are kept",
                                     [&] { return !controller.isPreviewing() && !controller.tasks().isBusy(); }));
    }
    return {{"voxels", voxels},
            {"candidates_median", quantileOf(candidates, 0.5)},
            {"drag", summary(dragged)},
            {"release", summary(released)}};
}

}  // namespace
}  // namespace fodscope

int main(int argc, char** argv) {
    CLI::App app("Times a dragged threshold in the window");
    std::size_t voxels = 200'000;
    std::size_t moves = 100;
    std::size_t fewest = 100;
    std::size_t most = 20'000;
    app.add_option("--voxels", voxels, "of the map")->check(CLI::Range(1000, 10'000'000));
    app.add_option("--moves", moves, "of the slider")->check(CLI::Range(1, 10'000));
    app.add_option("--fewest", fewest, "fewest voxels above the threshold")->check(CLI::PositiveNumber);
    app.add_option("--most", most, "most voxels above it")->check(CLI::PositiveNumber);
    CLI11_PARSE(app, argc, argv);
    const QTemporaryDir home;
    qputenv("HOME", home.path().toUtf8());
    qputenv("XDG_CONFIG_HOME", home.filePath(QStringLiteral("config")).toUtf8());
    fodscope::prepareApplication();
    const QApplication application(argc, argv);
    fodscope::applyTheme(*qApp, fodscope::ThemeKind::Dark);
    try {
        std::cout << fodscope::drag(voxels, moves, fewest, most) << "\n";
    } catch (const std::exception& problem) {
        std::cerr << "error: " << problem.what() << "\n";
        return 1;
    }
    return 0;
}
