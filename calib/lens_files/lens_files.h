#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "calib/capture/camera.h"

namespace lumi {

/// Files that hold a lens, ours and those of programs beside us.
enum class LensFormat {
    kToml,    ///< Ours: model, width_px, height_px, parameters.
    kColmap,  ///< cameras.txt with one camera.
    kOpenCv,  ///< YAML of cv::FileStorage, as OpenCV's calibration sample writes it.
    kKalibr,  ///< camchain.yaml with one camera.
    kRos,     ///< camera_info YAML, as camera_calibration writes it.
};

constexpr std::array<LensFormat, 5> kLensFormats{LensFormat::kToml, LensFormat::kColmap,
                                                 LensFormat::kOpenCv, LensFormat::kKalibr,
                                                 LensFormat::kRos};

/// "toml", "colmap", "opencv", "kalibr", "ros".
[[nodiscard]] std::string_view name_of(LensFormat format);
/// "camera.toml", "cameras.txt", "camera_opencv.yaml", "camchain.yaml", "camera_info.yaml".
[[nodiscard]] std::string_view usual_file_name(LensFormat format);

/// The lens as a file of this format holds it; every number is kept to the bit, except that all but
/// TOML and COLMAP count pixels from the centre of the first one and so lose half a pixel and find
/// it again. `remarks` become comments where the format has any. Throws Error (E-LENS-FORMAT) when
/// the format has no words for the lens (FULL_OPENCV in Kalibr).
[[nodiscard]] std::string lens_text(const Camera& lens, LensFormat format,
                                    const std::vector<std::string>& remarks = {});

/// Writes `lens_text` whole or not at all.
void write_lens_file(const std::filesystem::path& path, const Camera& lens, LensFormat format,
                     const std::vector<std::string>& remarks = {});

/// The lens in a file of any of the formats, recognised by the ending (.toml, .txt, .yaml, .yml)
/// and the content, and in BoofCV's intrinsic.yaml. Models come back as the simplest that says the
/// same: formats other than TOML and COLMAP know only OpenCV's distortion and the equidistant one.
/// Throws Error naming file and place: E-CONFIG-... (TOML), E-LENS-FILE (not such a file, or it
/// contradicts itself: sizes of matrices, skew, several cameras, another camera model),
/// E-CAMERA-INVALID, E-FILE-READ.
[[nodiscard]] Camera read_lens_file(const std::filesystem::path& path);

/// The simplest model that is exactly this: OpenCV's k1 k2 p1 p2 k3 k4 k5 k6.
[[nodiscard]] Camera simplest_lens(int width_px, int height_px, const Eigen::Vector2d& focal_px,
                                   const Eigen::Vector2d& centre_px,
                                   const std::array<double, 8>& distortion);

}  // namespace lumi
