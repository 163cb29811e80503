#include "calib/poses/firm_joints.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calib/adjust/bundle_adjustment.h"
#include "calib/doctor/capture_reason.h"
#include "calib/poses/part_joint.h"
#include "calib/poses/registration.h"

namespace lumi {
namespace {

using SharedCounts = std::vector<std::vector<int>>;

/// Points that two views share.
SharedCounts shared_counts(const Capture& capture) {
    const std::size_t views = capture.views.size();
    SharedCounts counts(views, std::vector<int>(views, 0));
    for (const ScenePoint& point : capture.points) {
        for (const Observation& first : point.track) {
            for (const Observation& second : point.track) {
                ++counts[static_cast<std::size_t>(first.view_index)]
                        [static_cast<std::size_t>(second.view_index)];
            }
        }
    }
    return counts;
}

struct TreeEdge {
    std::size_t parent = 0;
    std::size_t child = 0;
    int shared = 0;
};

/// From the first view on; each child comes after its parent (Prim 1957).
std::vector<TreeEdge> maximum_spanning_tree(const SharedCounts& counts) {
    const std::size_t views = counts.size();
    std::vector<TreeEdge> strongest(views);
    std::vector<char> is_reached(views, 0);
    std::vector<TreeEdge> tree;
    std::size_t newest = 0;
    for (std::size_t step = 1; step < views; ++step) {
        is_reached[newest] = 1;
        std::optional<TreeEdge> next;
        for (std::size_t view = 0; view < views; ++view) {
            if (is_reached[view] != 0) continue;
            TreeEdge& edge = strongest[view];
            if (step == 1 || counts[newest][view] > edge.shared) {
                edge = {newest, view, counts[newest][view]};
            }
            if (!next || edge.shared > next->shared) next = edge;
        }
        tree.push_back(*next);
        newest = next->child;
    }
    return tree;
}

/// For each edge of the tree, the weakest first: the smaller of the parts that it holds together.
std::vector<std::vector<char>> parts_of(const Capture& capture) {
    const std::size_t views = capture.views.size();
    const std::vector<TreeEdge> tree = maximum_spanning_tree(shared_counts(capture));
    std::vector<std::pair<int, std::vector<char>>> parts;
    for (std::size_t cut = 0; cut < tree.size(); ++cut) {
        std::vector<char> is_in_part(views, 0);
        is_in_part[tree[cut].child] = 1;
        for (std::size_t later = cut + 1; later < tree.size(); ++later) {
            is_in_part[tree[later].child] |= is_in_part[tree[later].parent];
        }
        const auto inside = std::count(is_in_part.begin(), is_in_part.end(), char{1});
        if (2 * inside > static_cast<std::ptrdiff_t>(views)) {
            for (char& is_in : is_in_part) is_in = is_in != 0 ? 0 : 1;
        }
        parts.emplace_back(tree[cut].shared, std::move(is_in_part));
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::vector<char>> result;
    for (auto& part : parts) result.push_back(std::move(part.second));
    return result;
}

/// Moves or drops one part; false when all joints are firm.
bool mend_one_joint(Capture& capture, const Progress& progress) {
    if (capture.views.size() < 3) return false;
    const double scale_px = cauchy_scale_px(capture);
    for (const std::vector<char>& is_in_part : parts_of(capture)) {
        PartJoint joint = examine_joint(capture, is_in_part, scale_px, progress);
        if (joint.is_elsewhere()) {
            capture = std::move(joint.other->moved);
            return true;
        }
        if (joint.is_weak()) {
            drop_views(capture, is_in_part);
            return true;
        }
    }
    return false;
}

}  // namespace

JointCheck with_firm_joints(const MappingJob& job, const Capture& mapped) {
    const std::size_t placed = mapped.views.size();
    job.progress.begin("asking how firmly the photographs hang together", 0);
    Capture firm = mapped;
    for (std::size_t round = 0; round < 2 * placed; ++round) {
        if (!mend_one_joint(firm, job.progress)) break;
    }
    const std::size_t left = firm.views.size();
    if (left == placed) return {std::move(firm), {}};
    const std::string what =
        "the photographs fall into parts, and what the parts share does not tell how they stand to "
        "each other: " +
        std::to_string(left) + " of " + std::to_string(placed) + " hang together";
    constexpr std::size_t kFewestViews = 3;
    if (left < kFewestViews || 2 * left < placed) return {mapped, what};
    job.evidence.warnings.push_back(std::string(code_of(CaptureReason::kSplit)) + ": " + what +
                                    ", and the others were left out; " +
                                    std::string(advice_for(CaptureReason::kSplit)));
    return {std::move(firm), {}};
}

}  // namespace lumi
