// SPDX-License-Identifier: Apache-2.0
#include "arguments/parse.h"
#include "arguments/storage_argument.h"
#include "arguments/volume_argument.h"
#include "commands/commands.h"
#include "reports/progress.h"

#include "gl/context.h"
#include "image/image.h"
#include "render/colours/transfer_function_json.h"
#include "render/marks/background.h"
#include "render/marks/draw_annotations.h"
#include "studio/document/document.h"

#include <CLI/CLI.hpp>
#include <fmt/ranges.h>

#include <memory>

namespace vs::cli {

namespace {

struct RenderOptions {
    std::shared_ptr<VolumeArgument> volume;
    StorageArgument storage;
    std::string output;
    std::string mode = "surface";
    std::string range;
    std::string size = "1230x870";
    std::string projection = "perspective";
    std::string sampling = "linear";
    std::string function;
    bool shadows = false;
    bool hidesAbove = false;
    bool isInverted = false;
    double surfaceSmoothing = 0;
    render::Camera camera;
    int samples = 8;
    std::string background = "studio";
    bool annotations = false;
};

void runRender(const RenderOptions& options) {
    // Values are checked before the volume is read: a typing mistake must not cost a minute.
    checkPictureName(options.output);
    const render::Mode mode = render::modeFromName(options.mode);
    const glm::ivec2 size = parseSize(options.size);
    const render::Background background = render::backgroundFromName(options.background);
    std::optional<Range> range;
    if (!options.range.empty()) {
        range = parseRange(options.range);
    }
    std::optional<render::TransferFunction> function;
    if (!options.function.empty()) {
        function = render::transferFunctionFromArgument(options.function);
    }
    // First: how much is worked on follows what its device has.
    const auto context = gl::Context::createHeadless();
    auto scan = loadScan(*options.volume, options.storage);
    const auto opened = documentOf(std::move(scan));
    studio::Document& document = *opened;
    studio::View view = document.view();
    view.camera = options.camera;
    view.camera.projection = options.projection == "perspective" ? render::Projection::Perspective
                                                                 : render::Projection::Orthographic;
    view.mode = mode;
    view.sampling = options.sampling == "cubic" ? field::Sampling::Tricubic : field::Sampling::Trilinear;
    view.range = range.value_or(view.range);
    view.transferFunction = function;
    view.shadows = options.shadows;
    view.hidesAbove = options.hidesAbove;
    view.isInverted = options.isInverted;
    view.surfaceSmoothing = options.surfaceSmoothing;
    document.showView(view);
    render::Frame frame = document.frame(size);
    frame.samples = options.samples;
    frame.background = background;
    render::RayCaster caster;
    caster.start(frame);
    {
        Progress progress("rendering", std::size_t(options.samples));
        for (int done = 0; !caster.renderSome(200); done = caster.completedSamples()) {
            progress.advance(std::size_t(caster.completedSamples() - done));
        }
    }
    context.requireNoErrors();
    tellFailures(document);
    image::Image picture = caster.readPicture();
    if (options.annotations) {
        render::annotate(picture, frame.rays, document.volume().geometry);
    }
    image::writePng(options.output, picture);
    fmt::print("{}: {} x {} pixels, {} from {:g} to {:g}, on {}\n", options.output, size.x, size.y,
               options.mode, view.range.lo, view.range.hi, context.device().renderer);
}

} // namespace

void addRenderCommand(CLI::App& app) {
    auto* command = app.add_subcommand("render", "Render one picture of a volume as PNG");
    auto options = std::make_shared<RenderOptions>();
    options->volume = addVolumeArgument(*command);
    addStorageOptions(*command, options->storage);
    command->add_option("-o,--output", options->output, "Picture to write (PNG)")->required();
    command
        ->add_option("--mode", options->mode,
                     "surface, mip, xray or volume (overlay and segment need a session)")
        ->capture_default_str();
    command->add_option("--range", options->range,
                        "Displayed range LO:HI; suggested from the histogram if not given");
    command->add_option("--tf", options->function,
                        fmt::format("Transfer function that colours every mode: a JSON file, or a preset: {}",
                                    fmt::join(render::presetNames(), ", ")));
    command->add_flag("--hide-above", options->hidesAbove,
                      "MIP and X-ray: hide values above the range instead of showing them as its upper end");
    command->add_flag(
        "--invert", options->isInverted,
        "MIP and X-ray: dark on light, the studio's background too; colours stay what they are");
    command
        ->add_option(
            "--smooth-surface", options->surfaceSmoothing,
            "Surface mode: sigma, in steps, of a Gaussian on the values before the surface is looked for")
        ->check(between(0, studio::kMostSurfaceSmoothing))
        ->capture_default_str();
    command->add_flag("--shadows", options->shadows, "Ambient occlusion and soft shadows");
    command->add_option("--size", options->size, "Pixels, WIDTHxHEIGHT")->capture_default_str();
    command
        ->add_option("--azimuth", options->camera.azimuthDegrees,
                     "Degrees; 0 looks at the face, positive moves the viewer to the patient's left")
        ->check(between(-1e6, 1e6));
    command
        ->add_option("--elevation", options->camera.elevationDegrees, "Degrees; positive moves the viewer up")
        ->check(between(-1e6, 1e6));
    command
        ->add_option("--roll", options->camera.rollDegrees, "Degrees; positive turns the picture clockwise")
        ->check(between(-1e6, 1e6));
    command->add_option("--zoom", options->camera.zoom, "1 frames the volume")
        ->check(between(1e-3, 1e3))
        ->capture_default_str();
    command->add_option("--projection", options->projection, "perspective or orthographic")
        ->check(CLI::IsMember({"perspective", "orthographic"}))
        ->capture_default_str();
    command
        ->add_option("--sampling", options->sampling,
                     "linear, or cubic: smooth where the picture is enlarged, slower")
        ->check(CLI::IsMember({"linear", "cubic"}))
        ->capture_default_str();
    command->add_option("--samples", options->samples, "Rays per pixel")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    command
        ->add_option("--background", options->background,
                     "studio, white, black, transparent, #RRGGBB or #RRGGBB:#RRGGBB (top and bottom)")
        ->capture_default_str();
    command->add_flag("--annotations", options->annotations, "Draw a scale bar and an orientation marker");
    command->callback([options] { runRender(*options); });
}

} // namespace vs::cli
