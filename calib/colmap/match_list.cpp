#include "calib/colmap/match_list.h"

#include "calib/colmap/colmap_database.h"

namespace lumi {

std::string colmap_match_list(const std::vector<PairMatches>& pairs) {
    std::string text;
    for (const PairMatches& pair : pairs) {
        text += colmap_image_name(pair.first) + ' ' + colmap_image_name(pair.second) + '\n';
        for (const FeatureMatch& match : pair.matches) {
            text += std::to_string(match.first) + ' ' + std::to_string(match.second) + '\n';
        }
        text += '\n';
    }
    return text;
}

}  // namespace lumi
