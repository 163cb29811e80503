#pragma once

#include <map>
#include <optional>
#include <string>

#include "render/frame/frame.h"

namespace lumi {

/// A method as it is compared with others.
struct ComparedMethod {
    std::string name;
    bool has_say = false;  ///< In which pixels are common.
};

/// Frames that several methods draw of the same views, judged on the same pixels: those that every
/// method covers that has a say. Each method's own coverage is no ground to compare them on:
/// whoever leaves out what is difficult would be ahead. Those have a say that the photographs'
/// depth tells what they know. Methods without depth cover what they know nothing of; what is
/// resampled covers what its own pictures hold, so that a narrow choice of these would be
/// everybody's.
class CommonPixels {
 public:
    /// One frame of a method and what should be seen in it.
    void add(const ComparedMethod& method, const std::string& view, const ColorImage& truth,
             const Frame& frame);

    /// Of a method's frame; empty where there is no such pixel. The frame was added.
    [[nodiscard]] std::optional<double> psnr_db(const std::string& method,
                                                const std::string& view) const;
    /// The mean over the views that have such pixels.
    [[nodiscard]] std::optional<double> mean_psnr_db(const std::string& method) const;
    /// Of all pixels of all views, the mean over views.
    [[nodiscard]] double share() const;

 private:
    struct View {
        ColorImage truth;
        GrayImage common;
        std::map<std::string, ColorImage> drawn;
    };
    std::map<std::string, View> views_;
};

/// Whether depth decides what a mode covers, where a Lumigraph has any, so that it has a say. Of
/// `heigl` its triangles decide, too, which depend on the eye.
[[nodiscard]] bool covers_by_depth(RenderMode mode);

/// The frame with other colours where it knows nothing, so that all methods show the same there.
[[nodiscard]] Frame filled(Frame frame, const ColorImage& surroundings);

}  // namespace lumi
