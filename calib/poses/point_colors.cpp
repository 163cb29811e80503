#include "calib/poses/point_colors.h"

#include <cmath>
#include <optional>

#include "calib/pictures/image_io.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

struct Place {
    std::size_t point = 0;
    std::size_t observation = 0;
};

std::vector<std::vector<Place>> places_by_view(const Capture& capture) {
    std::vector<std::vector<Place>> places(capture.views.size());
    for (std::size_t point = 0; point < capture.points.size(); ++point) {
        const auto& track = capture.points[point].track;
        for (std::size_t seen = 0; seen < track.size(); ++seen) {
            places[static_cast<std::size_t>(track[seen].view_index)].push_back({point, seen});
        }
    }
    return places;
}

/// Of every observation; empty where it lies beside the picture.
using ColorsOfTrack = std::vector<std::optional<Rgb8>>;

std::vector<Rgb8> shown(const ColorsOfTrack& colors) {
    std::vector<Rgb8> inside;
    for (const std::optional<Rgb8>& color : colors) {
        if (color) inside.push_back(*color);
    }
    return inside;
}

std::uint8_t mean_of(const std::vector<Rgb8>& colors, std::uint8_t Rgb8::*channel) {
    unsigned sum = 0;
    for (const Rgb8& color : colors) sum += color.*channel;
    const auto count = static_cast<unsigned>(colors.size());
    return static_cast<std::uint8_t>((sum + count / 2) / count);
}

}  // namespace

void color_points(Capture& capture, const std::vector<std::filesystem::path>& picture_paths,
                  int threads) {
    std::vector<ColorsOfTrack> colors;
    for (const ScenePoint& point : capture.points) colors.emplace_back(point.track.size());
    const std::vector<std::vector<Place>> places = places_by_view(capture);
    parallel_for(static_cast<int>(capture.views.size()), threads, [&](int view) {
        const auto index = static_cast<std::size_t>(view);
        const ColorImage picture = read_color_image(picture_paths[index]);
        for (const Place& place : places[index]) {
            const Eigen::Vector2d& pixel =
                capture.points[place.point].track[place.observation].pixel;
            const int x = static_cast<int>(std::floor(pixel.x()));
            const int y = static_cast<int>(std::floor(pixel.y()));
            if (picture.contains(x, y)) colors[place.point][place.observation] = picture(x, y);
        }
    });
    for (std::size_t index = 0; index < capture.points.size(); ++index) {
        const std::vector<Rgb8> seen = shown(colors[index]);
        if (seen.empty()) continue;
        capture.points[index].color = {mean_of(seen, &Rgb8::r), mean_of(seen, &Rgb8::g),
                                       mean_of(seen, &Rgb8::b)};
    }
}

}  // namespace lumi
