// SPDX-License-Identifier: MIT
#include "app/cli/DetectionRun.h"

#include <CLI/CLI.hpp>
#include <chrono>

#include "core/common/Error.h"

namespace fodscope::cli {
namespace {

void requireCovariance(const DetectionRun& run, const std::string& referenceFile) {
    if (run.parameters.candidates.metric != Metric::Mahalanobis || run.reference.reference->hasCovariance()) return;
    throw Error(referenceFile, "has no covariances, which the Mahalanobis metric needs",
                "use --metric euclidean, or a reference made with 'fodscope-cli reference --maps'");
}

/// The summary of a bad alignment is "what is wrong; what to do".
Error badAlignment(const std::string& mapFile, const std::string& summary) {
    const std::size_t divide = summary.find("; ");
    if (divide == std::string::npos) return Error(mapFile, summary, "give --transform or --initial");
    return Error(mapFile, summary.substr(0, divide), summary.substr(divide + 2));
}

}  // namespace

void addDetectionOptions(CLI::App& command, DetectionOptions& options) {
    command.add_option("--reference", options.reference, "reference map (PLY)")->required()->type_name("REF.ply");
    command.add_option("--map", options.map, "map under inspection (PCD or PLY)")->required()->type_name("MAP");
    CLI::Option* transform =
        command
            .add_option("--transform", options.transform, "reference from map, 4 rows of 4; replaces the registration")
            ->type_name("T.csv");
    command.add_option("--initial", options.initial, "start of the registration, reference from map, 4 rows of 4")
        ->type_name("T.csv")
        ->excludes(transform);
    addDetectionParameterOptions(command, options.parameters);
}

DetectionRun runDetection(const DetectionOptions& options, Context& context, AfterDetection after) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    DetectionRun run;
    run.parameters = parametersOf(options.parameters);
    DetectionPipeline pipeline;
    if (!options.transform.empty()) pipeline.setGivenTransform(readTransform(options.transform));
    if (!options.initial.empty()) pipeline.setStart(readTransform(options.initial));
    context.progress.report("reading the reference", 0.0);
    run.reference = loadReference(options.reference);
    requireCovariance(run, options.reference);
    run.map = loadMap(options.map, context);
    pipeline.setReference(run.reference.reference);
    if (after == AfterDetection::DropMap) {
        pipeline.giveMap(std::move(*run.map.cloud));
        run.map.cloud.reset();
    } else {
        pipeline.setMap(run.map.cloud);
    }
    run.loadSeconds = std::chrono::duration<double>(Clock::now() - begin).count();
    run.result = namingFiles({{"map", options.map}, {"reference", options.reference}},
                             [&] { return pipeline.run(run.parameters, context.progress); });
    return run;
}

void requireTrustedAlignment(const DetectionRun& run, const std::string& mapFile) {
    const RegistrationResult& registration = run.result.registration;
    if (!isTrusted(registration.quality)) throw badAlignment(mapFile, registration.summary);
}

}  // namespace fodscope::cli
