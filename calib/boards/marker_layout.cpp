#include "calib/boards/marker_layout.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>

namespace lumi {
namespace {

constexpr double kAgreeingShare = 0.75;

struct PlacedMarker {
    int id = 0;
    LatticeCell cell;
    int turn = 0;  ///< Quarter turns from the lattice's columns to the marker's own x axis.
};

/// Local geometry of a lattice: nodes in pixels and steps between them.
class CornerLattice {
 public:
    explicit CornerLattice(const std::vector<PatternNode>& nodes) {
        for (std::size_t index = 0; index < nodes.size(); ++index) {
            lattice_[nodes[index].cell] = index;
            points_px_.push_back(nodes[index].px);
        }
    }

    /// Coordinates of a pixel on the board, and what turns pixel directions into board directions.
    struct Place {
        Eigen::Vector2d at;
        Eigen::Matrix2d cells_from_px;
    };
    [[nodiscard]] std::optional<Place> place_of(const Eigen::Vector2d& px) const {
        const auto nearest =
            std::min_element(lattice_.begin(), lattice_.end(), [&](const auto& a, const auto& b) {
                return (points_px_[a.second] - px).squaredNorm() <
                       (points_px_[b.second] - px).squaredNorm();
            });
        const auto local = fit_around(lattice_, points_px_, nearest->first);
        if (!local) return std::nullopt;
        Eigen::Matrix2d steps;
        steps << local->column_step_px, local->row_step_px;
        const Eigen::Matrix2d cells_from_px = steps.inverse();
        const Eigen::Vector2d at = Eigen::Vector2d(nearest->first.column, nearest->first.row) +
                                   cells_from_px * (px - points_px_[nearest->second]);
        if (!at.allFinite()) return std::nullopt;
        return Place{at, cells_from_px};
    }

 private:
    Lattice lattice_;
    std::vector<Eigen::Vector2d> points_px_;
};

std::vector<PlacedMarker> placed_markers(const std::vector<PatternNode>& corners,
                                         const std::vector<DarkQuad>& quads,
                                         const MarkerFamily& family) {
    const CornerLattice lattice(corners);
    std::vector<PlacedMarker> placed;
    for (const MarkerReading& marker : family.markers) {
        const DarkQuad& quad = quads[marker.quad];
        const auto place = lattice.place_of(quad.centre_px);
        if (!place) continue;
        const Eigen::Vector2d x_axis =
            place->cells_from_px *
            (quad.corners_px[(marker.first_corner + 1) % 4] - quad.corners_px[marker.first_corner]);
        const double quarter_turns = std::atan2(x_axis.y(), x_axis.x()) / (0.5 * std::numbers::pi);
        placed.push_back({marker.id,
                          {static_cast<int>(std::floor(place->at.x())),
                           static_cast<int>(std::floor(place->at.y()))},
                          (static_cast<int>(std::lround(quarter_turns)) + 4) % 4});
    }
    return placed;
}

/// The cell in a lattice whose columns run along the markers' own x axis.
LatticeCell turned_back(LatticeCell cell, int turn) {
    for (int quarter = 0; quarter < turn; ++quarter) cell = {cell.row, -cell.column};
    return cell;
}

/// Where marker `id` is on a board with `columns` cells in a row, whose markers are in the cells
/// with column + row of `parity`.
LatticeCell cell_of_marker(int id, int columns, int parity) {
    const int pair = columns;  // Two rows together hold as many markers as a row has cells.
    const int row_pair = id / pair;
    int rest = id % pair;
    // Markers of an even row begin at column `parity`.
    const int in_even_row = (columns + 1 - parity) / 2;
    if (rest < in_even_row) return {2 * rest + parity, 2 * row_pair};
    rest -= in_even_row;
    return {2 * rest + 1 - parity, 2 * row_pair + 1};
}

template <class Key>
std::pair<Key, std::size_t> most_frequent(const std::map<Key, std::size_t>& votes) {
    const auto best =
        std::max_element(votes.begin(), votes.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    return best == votes.end() ? std::pair<Key, std::size_t>{}
                               : std::pair(best->first, best->second);
}

}  // namespace

std::optional<CharucoLayout> charuco_layout(const std::vector<PatternNode>& corners,
                                            const std::vector<DarkQuad>& quads,
                                            const MarkerFamily& family) {
    if (corners.empty() || family.markers.empty()) return std::nullopt;
    const std::vector<PlacedMarker> placed = placed_markers(corners, quads, family);
    std::map<int, std::size_t> turns;
    for (const PlacedMarker& marker : placed) ++turns[marker.turn];
    const int turn = most_frequent(turns).first;
    CharucoLayout best;
    std::size_t equally_good = 0;
    constexpr int kMaxColumns = 40;
    for (int columns = 2; columns <= kMaxColumns; ++columns) {
        for (int parity = 0; parity < 2; ++parity) {
            std::map<LatticeCell, std::size_t> offsets;
            for (const PlacedMarker& marker : placed) {
                if (marker.turn != turn) continue;
                const LatticeCell there = turned_back(marker.cell, turn);
                const LatticeCell said = cell_of_marker(marker.id, columns, parity);
                ++offsets[{there.column - said.column, there.row - said.row}];
            }
            const std::size_t agreeing = most_frequent(offsets).second;
            if (agreeing == best.markers) ++equally_good;
            if (agreeing > best.markers) {
                best = {columns, parity == 0, agreeing};
                equally_good = 0;
            }
        }
    }
    constexpr std::size_t kLeastMarkers = 3;
    if (best.markers < kLeastMarkers ||
        static_cast<double>(best.markers) < kAgreeingShare * static_cast<double>(placed.size())) {
        return std::nullopt;
    }
    if (equally_good > 0) best.columns = 0;
    return best;
}

std::optional<MarkerGridLayout> marker_grid_layout(const std::vector<PatternNode>& nodes,
                                                   const std::vector<int>& ids) {
    std::map<LatticeCell, int> id_at;
    for (std::size_t index = 0; index < nodes.size(); ++index) {
        id_at[nodes[index].cell] = ids[index];
    }
    std::map<int, std::size_t> along_columns;
    std::map<int, std::size_t> along_rows;
    for (const auto& [cell, id] : id_at) {
        const auto right = id_at.find({cell.column + 1, cell.row});
        const auto below = id_at.find({cell.column, cell.row + 1});
        if (right != id_at.end()) ++along_columns[right->second - id];
        if (below != id_at.end()) ++along_rows[below->second - id];
    }
    const auto [per_column, column_votes] = most_frequent(along_columns);
    const auto [per_row, row_votes] = most_frequent(along_rows);
    if (column_votes == 0 || row_votes == 0) return std::nullopt;
    std::map<int, std::size_t> first_ids;
    for (const auto& [cell, id] : id_at) {
        ++first_ids[id - per_column * cell.column - per_row * cell.row];
    }
    const auto [first_id, agreeing] = most_frequent(first_ids);
    const int smaller = std::min(std::abs(per_column), std::abs(per_row));
    const int larger = std::max(std::abs(per_column), std::abs(per_row));
    if (smaller != 1 ||
        static_cast<double>(agreeing) < kAgreeingShare * static_cast<double>(nodes.size())) {
        return std::nullopt;
    }
    MarkerGridLayout layout;
    layout.columns = larger;
    layout.markers = agreeing;
    for (std::size_t index = 0; index < nodes.size(); ++index) {
        const LatticeCell& cell = nodes[index].cell;
        layout.agrees.push_back(ids[index] ==
                                first_id + per_column * cell.column + per_row * cell.row);
    }
    return layout;
}

}  // namespace lumi
