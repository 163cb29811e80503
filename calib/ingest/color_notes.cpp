#include "calib/ingest/color_notes.h"

#include <algorithm>
#include <map>

#include "calib/ingest/working_copies.h"
#include "calib/work/formatted.h"
#include "calib/work/printable.h"

namespace lumi {
namespace {

std::string photographs_text(std::size_t count, const char* one, const char* several) {
    return std::to_string(count) + (count == 1 ? " photograph " : " photographs ") +
           (count == 1 ? one : several);
}

/// The names of the first few.
std::string first_names(const std::vector<std::string>& names) {
    constexpr std::size_t kMaxNamed = 5;
    std::string text;
    for (std::size_t i = 0; i < std::min(kMaxNamed, names.size()); ++i) {
        text += (i == 0 ? "" : ", ") + printable(names[i]);
    }
    if (names.size() > kMaxNamed) {
        text += " and " + std::to_string(names.size() - kMaxNamed) + " more";
    }
    return text;
}

/// Of the photographs with a share of their pixels above 0.
struct Concerned {
    std::size_t count = 0;
    double largest_share = 0.0;
    std::string name_of_largest;

    void add(double share, const std::string& name) {
        if (!(share > 0)) return;
        ++count;
        if (share <= largest_share) return;
        largest_share = share;
        name_of_largest = name;
    }
    [[nodiscard]] std::string text() const {
        return formatted("up to %.3g %% of the pixels, in ", 100 * largest_share) +
               printable(name_of_largest);
    }
};

/// Of a few that are black and white among colored ones, or the other way round; empty where all
/// are alike.
std::string text_of_lost_color(const std::vector<std::string>& colored,
                               const std::vector<std::string>& colorless) {
    if (colored.empty() || colorless.empty()) return {};
    const std::string advice = "; pictures drawn from both are tinted: leave out ";
    if (colorless.size() <= colored.size())
        return photographs_text(colorless.size(), "is", "are") +
               " black and white, the others have colours: " + first_names(colorless) + advice +
               "what has none, or take all without";
    return photographs_text(colored.size(), "has", "have") +
           " colours, the others are black and white: " + first_names(colored) + advice +
           "what has them, or take them away";
}

}  // namespace

std::vector<std::string> color_notes(const std::vector<Candidate>& candidates) {
    std::map<std::string, std::size_t> converted_from;
    std::map<std::string, std::vector<std::string>> names_of_fault;
    Concerned clipped;
    Concerned hidden;
    std::vector<std::string> colored;
    std::vector<std::string> colorless;
    for (const Candidate& candidate : candidates) {
        if (candidate.left_out) continue;
        const ColorConversion& conversion = candidate.conversion;
        const std::string& name = candidate.photograph.name;
        if (!conversion.from.empty()) ++converted_from[conversion.from];
        if (!conversion.profile_fault.empty()) {
            names_of_fault[conversion.profile_fault].push_back(name);
        }
        clipped.add(conversion.clipped_share, name);
        hidden.add(conversion.hidden_share, name);
        (candidate.has_color ? colored : colorless).push_back(name);
    }
    std::vector<std::string> notes;
    for (const auto& [from, count] : converted_from) {
        notes.push_back(photographs_text(count, "was", "were") + " converted from " + from +
                        " to sRGB");
    }
    if (clipped.count > 0) {
        notes.push_back(
            photographs_text(clipped.count, "is", "are") +
            " brighter than white (1.0) in places and cut off there: " + clipped.text());
    }
    for (const auto& [fault, names] : names_of_fault) {
        notes.push_back(photographs_text(names.size(), "was", "were") +
                        " taken as sRGB, for the embedded colour profile " + fault +
                        " (E-INGEST-PROFILE): " + first_names(names));
    }
    if (hidden.count > 0) {
        notes.push_back(
            photographs_text(hidden.count, "is", "are") +
            " cut out by an alpha channel, and black where it hides them: " + hidden.text() +
            "; unless all hide the same, or [depth] masks or background say otherwise, what is "
            "left is the subject that depth is found of");
    }
    const std::string lost_color = text_of_lost_color(colored, colorless);
    if (!lost_color.empty()) notes.push_back(lost_color);
    return notes;
}

}  // namespace lumi
