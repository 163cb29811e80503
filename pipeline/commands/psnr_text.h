#pragma once

#include <optional>
#include <string>

namespace lumi {

/// What people are told of a frame beside the photograph taken there: "30.41 dB, 30.93 dB where it
/// is covered (97.9 %)". `covered_db` is empty where nothing is covered.
[[nodiscard]] std::string psnr_text(double whole_db, std::optional<double> covered_db,
                                    double coverage);

}  // namespace lumi
