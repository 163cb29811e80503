#pragma once

#include <string>

namespace lumi {

/// What a package should reach.
struct Wish {
    enum class Kind {
        kFramesPerSecond,  ///< At the size of the photographs, at least: "30fps".
        kPsnrDb,           ///< On held-out photographs, at least: "30dB".
        kPackageMib,       ///< At most: "50MiB".
        kBuildSeconds,     ///< From photographs to the package, at most: "5min", "90s".
    };
    Kind kind = Kind::kPsnrDb;
    double value = 0.0;
    std::string text;  ///< As it was said.
};

/// Throws Error (kUsage, E-TARGET-WISH) saying what can be wished for.
[[nodiscard]] Wish wish_from(const std::string& text);

/// What a package measures.
struct Achievement {
    double frames_per_second = 0.0;
    double psnr_db = 0.0;
    double package_mib = 0.0;
    double build_s = 0.0;
};

/// The figure that the wish is about, in its unit.
[[nodiscard]] double figure_of(const Wish& wish, const Achievement& achievement);
[[nodiscard]] bool meets(const Wish& wish, const Achievement& achievement);
/// How far a figure stays behind the wish, as a share of it; 0 when it is met.
[[nodiscard]] double shortfall(const Wish& wish, const Achievement& achievement);
/// "24.3 dB".
[[nodiscard]] std::string figure_text(const Wish& wish, const Achievement& achievement);

}  // namespace lumi
