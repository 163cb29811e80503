#include "calib/ingest/duplicates.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include "calib/ingest/working_copies.h"
#include "calib/pictures/image_io.h"
#include "calib/work/content_hash.h"

namespace lumi {
namespace {

LeftOut duplicate(const std::string& name, const std::string& reason) {
    return {name, "E-INGEST-DUPLICATE", reason};
}

/// A name but for the digits in it: "m#.jpg" of m07.jpg. A camera's photographs have it in common.
std::string pattern_of(const std::string& name) {
    std::string pattern;
    for (const char c : name) {
        if (c < '0' || c > '9') {
            pattern += c;
        } else if (pattern.empty() || pattern.back() != '#') {
            pattern += '#';
        }
    }
    return pattern;
}

/// Of candidates with the same pixels the one that is named like most others, by those pixels; of
/// several the first.
std::map<std::string, const Candidate*> originals_of(const std::vector<Candidate>& candidates) {
    std::map<std::string, int> count_of_pattern;
    for (const Candidate& candidate : candidates) {
        if (!candidate.left_out) ++count_of_pattern[pattern_of(candidate.photograph.name)];
    }
    std::map<std::string, const Candidate*> originals;
    const auto count_of = [&](const Candidate& candidate) {
        return count_of_pattern.at(pattern_of(candidate.photograph.name));
    };
    for (const Candidate& candidate : candidates) {
        if (candidate.left_out) continue;
        const Candidate*& original = originals[candidate.pixels_sha256];
        if (original == nullptr || count_of(candidate) > count_of(*original)) original = &candidate;
    }
    return originals;
}

}  // namespace

std::string pixels_sha256(const ColorImage& raster) {
    static_assert(sizeof(Rgb8) == 3);
    const std::span<const std::uint8_t> bytes(&raster.pixels()[0].r, 3 * raster.pixels().size());
    return std::to_string(raster.width()) + "x" + std::to_string(raster.height()) + ":" +
           sha256_hex(bytes);
}

ColorImage thumbnail_of(const ColorImage& picture) {
    constexpr int kLongerSidePx = 128;
    const int longer = std::max(picture.width(), picture.height());
    const double scale = std::min(1.0, static_cast<double>(kLongerSidePx) / longer);
    const auto scaled = [&](int side) {
        return std::max(1, static_cast<int>(std::lround(scale * side)));
    };
    return resized(picture, scaled(picture.width()), scaled(picture.height()));
}

bool hardly_differ(const ColorImage& a, const ColorImage& b) {
    if (a.width() != b.width() || a.height() != b.height()) return false;
    // Noise of 5 levels averages out to 0.4 in a thumbnail pixel that covers 12 x 12 pixels, so its
    // mean difference is about 0.5 and the largest of some ten thousand about 3.
    constexpr int kMaxDifference = 4;
    constexpr double kMaxMeanDifference = 0.6;
    long sum = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const Rgb8& p = a.pixels()[i];
        const Rgb8& q = b.pixels()[i];
        for (const int difference : {p.r - q.r, p.g - q.g, p.b - q.b}) {
            if (std::abs(difference) > kMaxDifference) return false;
            sum += std::abs(difference);
        }
    }
    return static_cast<double>(sum) <=
           kMaxMeanDifference * 3 * static_cast<double>(a.pixels().size());
}

void leave_out_duplicates(std::vector<Candidate>& candidates) {
    const std::map<std::string, const Candidate*> originals = originals_of(candidates);
    const Candidate* last_kept = nullptr;
    for (Candidate& candidate : candidates) {
        if (candidate.left_out) continue;
        const std::string& name = candidate.photograph.name;
        const Candidate* original = originals.at(candidate.pixels_sha256);
        if (original != &candidate) {
            candidate.left_out =
                duplicate(name, "the same picture as " + original->photograph.name);
        } else if (last_kept != nullptr &&
                   hardly_differ(last_kept->thumbnail, candidate.thumbnail)) {
            candidate.left_out =
                duplicate(name, "hardly differs from " + last_kept->photograph.name +
                                    ": the camera did not move in between");
        } else {
            last_kept = &candidate;
        }
    }
}

}  // namespace lumi
