#include "pipeline/commands/frame_drawer.h"

#include <memory>
#include <utility>

#include "pipeline/evaluate/common_pixels.h"
#include "render/renderer/mode_reference.h"
#include "render/renderer/offscreen_renderer.h"
#include "render/rivals/dynamically_reparameterized.h"
#include "render/surroundings/surroundings.h"

namespace lumi {
namespace {

Draw through_aperture(const Lumigraph& lumigraph, const SyntheticAperture& aperture,
                      const RenderOptions& options) {
    // Where nothing fades, what is not covered is guessed also in packages that are to fade.
    RenderOptions unfaded = options;
    unfaded.fade_beyond_capture = false;
    const bool guesses = are_surroundings_drawn(unfaded);
    return [&lumigraph, aperture, guesses](const Eye& eye) {
        Frame frame = draw_dynamically_reparameterized(lumigraph, eye, aperture);
        return guesses ? filled(std::move(frame), surroundings_picture(lumigraph, eye)) : frame;
    };
}

}  // namespace

FrameDrawer frame_drawer(const Lumigraph& lumigraph, const RenderOptions& options, double aperture,
                         bool by_reference) {
    if (aperture > 0)
        return {through_aperture(
                    lumigraph, {.diameter = aperture, .focal_plane = options.focal_plane}, options),
                "synthetic aperture"};
    if (by_reference)
        return {[&lumigraph, options](const Eye& eye) {
                    return draw_mode_reference(lumigraph, eye, options);
                },
                "reference"};
    const auto renderer = std::make_shared<OffscreenRenderer>(lumigraph);
    return {[renderer, options](const Eye& eye) { return renderer->draw(eye, options); },
            renderer->gl_description()};
}

}  // namespace lumi
