#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pipeline/bench/rival_figures.h"
#include "pipeline/bench/rival_scenes.h"
#include "pipeline/evaluate/common_pixels.h"

namespace lumi {

/// Draws one frame by some method.
using DrawFrame = std::function<Frame(const Eye&)>;

/// Which method draws, from what.
struct RivalMethod {
    std::string method;
    std::string settings;
    int pictures = 0;
    bool has_say = false;  ///< In which pixels are common (CommonPixels).
};

/// A picture at a held-out place, whose `index` counts from 0: what `method` (with its settings)
/// draws there, as it draws it, or "photograph".
struct RivalPicture {
    std::string scene;
    std::string method;
    std::size_t index = 0;
    const ColorImage& picture;
};
using RivalPictureSink = std::function<void(const RivalPicture&)>;

/// Measures the pictures that several methods draw of one capture, all on the same pixels.
class RivalMeasurement {
 public:
    /// `capture` outlives this. `keep` is called with the photographs at held-out places, and with
    /// what each method draws there.
    explicit RivalMeasurement(
        const RivalCapture& capture, RivalPictureSink keep = [](const RivalPicture&) {});

    /// The figures of a method's pictures, but for those of common pixels, and no times. Those of
    /// held-out places are drawn first.
    [[nodiscard]] RivalFigures measured(const RivalMethod& method, const DrawFrame& draw);

    /// Fills in what is measured on the pixels that all methods with a say cover: those of
    /// `rivals`, which are all that were measured.
    void measure_common_pixels(std::vector<RivalFigures>& rivals) const;
    [[nodiscard]] double common_share() const { return common_.share(); }
    [[nodiscard]] double off_cameras_common_share() const { return off_cameras_common_.share(); }

 private:
    [[nodiscard]] OffCamerasFigures off_cameras_of(const RivalMethod& method,
                                                   const DrawFrame& draw);
    [[nodiscard]] double flicker_of(const DrawFrame& draw) const;

    const RivalCapture& capture_;
    RivalPictureSink keep_;
    std::vector<ColorImage> held_out_surroundings_;
    std::vector<ColorImage> off_cameras_surroundings_;
    std::vector<ColorImage> path_surroundings_;
    CommonPixels common_;
    CommonPixels off_cameras_common_;
};

}  // namespace lumi
