#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>

namespace lumi {

/// Lens models with COLMAP's names, ids and parameter order (COLMAP 3.8, base/camera_models.h).
enum class LensModel : int {
    kSimplePinhole = 0,  ///< f, cx, cy
    kPinhole = 1,        ///< fx, fy, cx, cy
    kSimpleRadial = 2,   ///< f, cx, cy, k1
    kRadial = 3,         ///< f, cx, cy, k1, k2
    kOpenCv = 4,         ///< fx, fy, cx, cy, k1, k2, p1, p2
    kOpenCvFisheye = 5,  ///< fx, fy, cx, cy, k1, k2, k3, k4
    kFullOpenCv = 6,     ///< fx, fy, cx, cy, k1, k2, p1, p2, k3, k4, k5, k6
};

struct LensModelEntry {
    LensModel model;
    std::string_view name;
    std::size_t parameters;
};

inline constexpr std::array<LensModelEntry, 7> kLensModels{{
    {LensModel::kSimplePinhole, "SIMPLE_PINHOLE", 3},
    {LensModel::kPinhole, "PINHOLE", 4},
    {LensModel::kSimpleRadial, "SIMPLE_RADIAL", 4},
    {LensModel::kRadial, "RADIAL", 5},
    {LensModel::kOpenCv, "OPENCV", 8},
    {LensModel::kOpenCvFisheye, "OPENCV_FISHEYE", 8},
    {LensModel::kFullOpenCv, "FULL_OPENCV", 12},
}};

[[nodiscard]] constexpr const LensModelEntry& entry_of(LensModel model) {
    return *std::find_if(kLensModels.begin(), kLensModels.end(),
                         [&](const LensModelEntry& entry) { return entry.model == model; });
}

[[nodiscard]] constexpr std::string_view name_of(LensModel model) { return entry_of(model).name; }

[[nodiscard]] constexpr std::optional<LensModel> lens_model_named(std::string_view name) {
    for (const LensModelEntry& entry : kLensModels) {
        if (entry.name == name) return entry.model;
    }
    return std::nullopt;
}

[[nodiscard]] constexpr bool is_lens_model(int id) {
    return std::any_of(kLensModels.begin(), kLensModels.end(), [&](const LensModelEntry& entry) {
        return static_cast<int>(entry.model) == id;
    });
}

[[nodiscard]] constexpr std::size_t parameter_count(LensModel model) {
    return entry_of(model).parameters;
}

/// True for the models that begin f, cx, cy; the others begin fx, fy, cx, cy.
[[nodiscard]] constexpr bool has_one_focal_length(LensModel model) {
    return model == LensModel::kSimplePinhole || model == LensModel::kSimpleRadial ||
           model == LensModel::kRadial;
}

/// Index of cx; cy comes next.
[[nodiscard]] constexpr std::size_t principal_point_index(LensModel model) {
    return has_one_focal_length(model) ? 1 : 2;
}

/// Index of the first parameter behind the principal point.
[[nodiscard]] constexpr std::size_t first_distortion_parameter(LensModel model) {
    return principal_point_index(model) + 2;
}

/// Calls `work` with the model as a compile-time constant.
template <class Work>
decltype(auto) with_lens_model(LensModel model, Work&& work) {
    using M = LensModel;
    switch (model) {
        case M::kSimplePinhole:
            return work(std::integral_constant<M, M::kSimplePinhole>{});
        case M::kPinhole:
            return work(std::integral_constant<M, M::kPinhole>{});
        case M::kSimpleRadial:
            return work(std::integral_constant<M, M::kSimpleRadial>{});
        case M::kRadial:
            return work(std::integral_constant<M, M::kRadial>{});
        case M::kOpenCv:
            return work(std::integral_constant<M, M::kOpenCv>{});
        case M::kFullOpenCv:
            return work(std::integral_constant<M, M::kFullOpenCv>{});
        case M::kOpenCvFisheye:
            break;
    }
    return work(std::integral_constant<M, M::kOpenCvFisheye>{});
}

}  // namespace lumi
