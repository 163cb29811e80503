#include "pipeline/target/wish.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "calib/work/error.h"
#include "pipeline/text/number_text.h"

namespace lumi {
namespace {

struct Unit {
    const char* name;
    Wish::Kind kind;
    double factor;
};

constexpr std::array<Unit, 5> kUnits{{{"fps", Wish::Kind::kFramesPerSecond, 1.0},
                                      {"dB", Wish::Kind::kPsnrDb, 1.0},
                                      {"MiB", Wish::Kind::kPackageMib, 1.0},
                                      {"min", Wish::Kind::kBuildSeconds, 60.0},
                                      {"s", Wish::Kind::kBuildSeconds, 1.0}}};

bool more_is_better(Wish::Kind kind) {
    return kind == Wish::Kind::kFramesPerSecond || kind == Wish::Kind::kPsnrDb;
}

}  // namespace

Wish wish_from(const std::string& text) {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, value);
    std::string unit(parsed.ptr, end);
    unit.erase(0, unit.find_first_not_of(' '));
    for (const Unit& known : kUnits) {
        if (unit != known.name || parsed.ec != std::errc() || !std::isfinite(value)) continue;
        if (value > 0.0) return {known.kind, value * known.factor, text};
    }
    throw Error(ErrorKind::kUsage, "E-TARGET-WISH",
                "--target " + text + ": expected a number above 0 and a unit",
                "say 30fps, 30dB, 50MiB, 5min or 90s");
}

double figure_of(const Wish& wish, const Achievement& achievement) {
    switch (wish.kind) {
        case Wish::Kind::kFramesPerSecond:
            return achievement.frames_per_second;
        case Wish::Kind::kPsnrDb:
            return achievement.psnr_db;
        case Wish::Kind::kPackageMib:
            return achievement.package_mib;
        case Wish::Kind::kBuildSeconds:
            return achievement.build_s;
    }
    return 0.0;
}

bool meets(const Wish& wish, const Achievement& achievement) {
    const double figure = figure_of(wish, achievement);
    return more_is_better(wish.kind) ? figure >= wish.value : figure <= wish.value;
}

double shortfall(const Wish& wish, const Achievement& achievement) {
    const double figure = figure_of(wish, achievement);
    const double missing = more_is_better(wish.kind) ? wish.value - figure : figure - wish.value;
    return std::max(0.0, missing / wish.value);
}

std::string figure_text(const Wish& wish, const Achievement& achievement) {
    const double figure = figure_of(wish, achievement);
    switch (wish.kind) {
        case Wish::Kind::kFramesPerSecond:
            return number_text(figure, 1) + " frames a second";
        case Wish::Kind::kPsnrDb:
            return number_text(figure, 2) + " dB";
        case Wish::Kind::kPackageMib:
            return number_text(figure, 1) + " MiB";
        case Wish::Kind::kBuildSeconds:
            return number_text(figure, 1) + " s";
    }
    return {};
}

}  // namespace lumi
