#include "calib/adjust/longest_tracks.h"

#include <algorithm>
#include <numeric>

namespace lumi {

std::vector<std::size_t> longest_tracks(const std::vector<std::vector<int>>& views_of_track,
                                        std::size_t views, int tracks_a_view) {
    std::vector<std::size_t> order(views_of_track.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return views_of_track[a].size() > views_of_track[b].size();
    });
    std::vector<int> chosen_of_view(views, 0);
    std::erase_if(order, [&](std::size_t track) {
        const std::vector<int>& seen_by = views_of_track[track];
        const bool is_wanted = std::any_of(seen_by.begin(), seen_by.end(), [&](int view) {
            return chosen_of_view[static_cast<std::size_t>(view)] < tracks_a_view;
        });
        if (!is_wanted) return true;
        for (const int view : seen_by) ++chosen_of_view[static_cast<std::size_t>(view)];
        return false;
    });
    return order;
}

}  // namespace lumi
