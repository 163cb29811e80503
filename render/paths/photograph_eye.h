#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/image.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The eye turned about its optical axis, so that the picture of a camera held as the EXIF
/// orientation (1 to 8) says is upright. Mirrored orientations are turned and not mirrored: a view
/// of the world has no left and right to swap.
[[nodiscard]] Eye turned_upright(const Eye& eye, int exif_orientation);

/// The picture turned alike.
[[nodiscard]] ColorImage turned_upright(const ColorImage& picture, int exif_orientation);
[[nodiscard]] GrayImage turned_upright(const GrayImage& picture, int exif_orientation);

/// The eye that stood where the photograph was taken, its picture upright.
[[nodiscard]] Eye eye_at(const LumigraphView& view);

/// The eye with a frame of another size: the whole old picture is in it, centred, as large as fits.
[[nodiscard]] Eye fitted_to(const Eye& eye, int width_px, int height_px);

/// Pixels of the fitted frame per pixel of the eye's own picture.
[[nodiscard]] double fitting_scale(const Eye& eye, int width_px, int height_px);

/// Which of these names of photographs is `wanted`; or else the only one, if there is one alone,
/// that is without folder and ending.
[[nodiscard]] std::optional<int> index_of_name(const std::vector<std::string>& names,
                                               const std::string& wanted);
/// The first few of them, for advice.
[[nodiscard]] std::string listed_names(const std::vector<std::string>& names);

[[nodiscard]] std::vector<std::string> names_of_views(const Lumigraph& lumigraph);

/// The view whose name is `name` (index_of_name). Throws Error (E-VIEW-NAME) that lists names when
/// there is none.
[[nodiscard]] int index_of_view(const Lumigraph& lumigraph, const std::string& name);

/// The direction that is up in the scene, as far as photographs tell it; of length one.
///
/// People hold cameras level: the x axes r of the upright cameras are horizontal, whether they look
/// up or down, up to a roll of mean square s^2. The mean m of their y axes, reversed, leans where
/// cameras that look down stand on one side. So the direction is that of the u which makes
///     mean((r . u)^2) / s^2 + 2 |u - m|^2
/// least, (M + 2 s^2 I)^-1 m with M the mean of r r^T: m may lean by some 40 degrees, and r rise by
/// s. s is found with u in turn, 2.2 degrees at least. Where the cameras look all one way, or are
/// rolled as much as they look different ways, nothing tells a lean, and it stays m.
[[nodiscard]] Eigen::Vector3d up_in_world(const Lumigraph& lumigraph);

}  // namespace lumi
