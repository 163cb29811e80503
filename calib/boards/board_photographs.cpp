#include <algorithm>
#include <array>
#include <compare>
#include <map>
#include <new>
#include <opencv2/core.hpp>

#include "calib/boards/board_detection.h"
#include "calib/capture/gray.h"
#include "calib/ingest/photograph_folder.h"
#include "calib/pictures/image_io.h"
#include "calib/work/counted.h"
#include "calib/work/median.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

/// One kind of each way of looking; the answer says which special case it is.
constexpr std::array<BoardKind, 3> kWaysOfLooking{BoardKind::kChessboard, BoardKind::kSquareGrid,
                                                  BoardKind::kCircles};

std::string size_text(const ImageSize& size) {
    return std::to_string(size.width_px) + " x " + std::to_string(size.height_px);
}

/// Photographs by their size.
using FilesOfSize = std::map<std::pair<int, int>, std::vector<PhotographFile>>;

FilesOfSize readable_by_size(const PhotographFolder& folder, std::vector<LeftOut>& left_out) {
    FilesOfSize files_of_size;
    for (const PhotographFile& file : folder.files) {
        try {
            const ImageSize size = read_image_size(file.path);
            files_of_size[{size.width_px, size.height_px}].push_back(file);
        } catch (const Error& error) {
            left_out.push_back({file.name, error.code(), error.what()});
        }
    }
    return files_of_size;
}

[[noreturn]] void refuse_sizes(const FilesOfSize& files_of_size) {
    std::string sizes;
    for (const auto& [wide_high, files] : files_of_size) {
        sizes += (sizes.empty() ? "" : ", ") + size_text({wide_high.first, wide_high.second}) +
                 " (" + std::to_string(files.size()) + ": " + files.front().name +
                 (files.size() > 1 ? " ..." : "") + ")";
    }
    throw Error(ErrorKind::kBadInput, "E-BOARDS-SIZES",
                "the photographs have several sizes, none of them most, and a lens is calibrated "
                "for one: " +
                    sizes,
                "calibrate each size in a folder of its own, and give photographs as the camera "
                "wrote them (not turned or cropped)");
}

/// The photographs that can be read and have the size of most; the others are left out. Which way
/// one was turned upright its raster does not tell, and with it where the middle of the lens went.
std::vector<PhotographFile> readable_of_one_size(const PhotographFolder& folder, ImageSize& size,
                                                 std::vector<LeftOut>& left_out) {
    const FilesOfSize files_of_size = readable_by_size(folder, left_out);
    if (files_of_size.empty()) return {};
    std::size_t readable = 0;
    for (const auto& [wide_high, files] : files_of_size) readable += files.size();
    const auto most = std::max_element(
        files_of_size.begin(), files_of_size.end(),
        [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
    if (2 * most->second.size() <= readable) refuse_sizes(files_of_size);
    size = {most->first.first, most->first.second};
    for (const auto& [wide_high, files] : files_of_size) {
        if (wide_high == most->first) continue;
        const auto& [wide, high] = wide_high;
        const bool is_turned = wide == size.height_px && high == size.width_px;
        for (const PhotographFile& file : files) {
            left_out.push_back(
                {file.name, "E-BOARD-SIZE",
                 "it has " + size_text({wide, high}) + " pixels, the most have " + size_text(size) +
                     (is_turned ? ": it was turned after it was taken; give it as the camera wrote "
                                  "it"
                                : ": another camera or setting, or cropped or resized")});
        }
    }
    return most->second;
}

BoardAnswer answer_for(const PhotographFile& file, BoardKind kind, const BoardRequest& request) {
    try {
        return detect_board(gray_of(read_color_image(file.path)), file.name, kind, request);
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::kInterrupted) throw;
        return {std::nullopt, {file.name, error.code(), error.what()}};
    } catch (const cv::Exception& exception) {
        if (exception.code == cv::Error::StsNoMem) throw std::bad_alloc();
        // Such as a window that is larger than the picture.
        return {std::nullopt,
                {file.name, "E-BOARD-FAILED", "OpenCV cannot look at it: " + exception.err}};
    }
}

std::vector<BoardAnswer> answers_for(const std::vector<PhotographFile>& files, BoardKind kind,
                                     const BoardRequest& request, int threads, Progress& progress) {
    std::vector<BoardAnswer> answers(files.size());
    parallel_for(static_cast<int>(files.size()), threads, [&](int index) {
        progress.throw_if_interrupted();
        const auto at = static_cast<std::size_t>(index);
        answers[at] = answer_for(files[at], kind, request);
        progress.advance();
    });
    return answers;
}

/// What speaks for a way of looking, the weightiest first.
struct WayScore {
    /// Photographs in which markers agree with their places, if most do: chance does not do that,
    /// while the dark cells of a chessboard and the markers between them pass for a grid of
    /// squares.
    std::size_t with_markers = 0;
    std::size_t found = 0;
    std::size_t points = 0;

    auto operator<=>(const WayScore&) const = default;
};

WayScore score_of(const std::vector<BoardAnswer>& answers) {
    WayScore score;
    for (const BoardAnswer& answer : answers) {
        if (!answer.board) continue;
        ++score.found;
        if (!answer.board->markers.empty()) ++score.with_markers;
        score.points += answer.board->view.points.size();
    }
    if (2 * score.with_markers <= score.found) score.with_markers = 0;
    return score;
}

/// The way of looking that finds a board in most of a sample of the photographs; of those that
/// find it equally often, the one that finds more points.
BoardKind kind_in_sample(const std::vector<PhotographFile>& files, const BoardRequest& request,
                         int threads, Progress& progress) {
    constexpr std::size_t kSample = 6;
    std::vector<PhotographFile> sample;
    const std::size_t step = std::max<std::size_t>(1, (files.size() + kSample - 1) / kSample);
    for (std::size_t index = 0; index < files.size(); index += step) sample.push_back(files[index]);
    progress.begin("which board", sample.size() * kWaysOfLooking.size());
    BoardKind best = kWaysOfLooking.front();
    WayScore best_score;
    for (const BoardKind kind : kWaysOfLooking) {
        const std::vector<BoardAnswer> answers =
            answers_for(sample, kind, request, threads, progress);
        const WayScore score = score_of(answers);
        if (score > best_score) {
            best_score = score;
            best = kind;
        }
    }
    return best;
}

/// The special case that most photographs show: the others show too little to tell.
BoardKind most_frequent_kind(const std::vector<BoardDetection>& detections) {
    std::map<BoardKind, std::size_t> points;
    for (const BoardDetection& detection : detections) {
        points[detection.kind] += detection.view.points.size();
    }
    return std::max_element(points.begin(), points.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
}

bool is_hexagonal(BoardKind kind) { return kind == BoardKind::kHexagonalCircles; }

double median_size(const std::vector<BoardDetection>& detections) {
    std::vector<double> sizes;
    for (const BoardDetection& detection : detections) sizes.push_back(detection.size_per_pitch);
    return median_of(std::move(sizes));
}

/// What was said of the size and no photograph confirms.
std::vector<std::string> doubts_of_size(const BoardPhotographs& found,
                                        const BoardRequest& request) {
    if (request.columns == 0 || request.rows == 0) return {};
    const auto [less, more] = std::minmax(request.columns, request.rows);
    if (!has_definite_size(found.kind)) {
        return {"rows of " + std::string(name_of(found.kind)) +
                " are counted in more than one way: the size that was said was not used"};
    }
    if (found.columns >= more && found.rows >= less) return {};
    return {"a board of " + std::to_string(more) + " x " + std::to_string(less) +
            " was said, and no photograph shows more than " + std::to_string(found.columns) +
            " x " + std::to_string(found.rows) +
            " of it: parts are used as well, but check that it is this board"};
}

[[noreturn]] void refuse_without_board(const BoardPhotographs& found, const BoardRequest& request) {
    std::string examples;
    constexpr std::size_t kExamples = 3;
    for (std::size_t index = 0; index < std::min(kExamples, found.left_out.size()); ++index) {
        examples += "; " + found.left_out[index].name + ": " + found.left_out[index].reason;
    }
    const std::string photographs = counted(found.photographs, "photograph");
    const auto larger =
        std::find_if(found.left_out.begin(), found.left_out.end(),
                     [](const LeftOut& left_out) { return left_out.code == "E-BOARD-LARGER"; });
    if (larger != found.left_out.end()) {
        throw Error(ErrorKind::kBadInput, "E-BOARDS-LARGER",
                    "none of " + photographs + " shows a board as small as the one described; " +
                        larger->name + ": " + larger->reason,
                    "leave out --size, or give the columns and rows of inner corners (not of "
                    "cells), discs, squares or markers");
    }
    throw Error(ErrorKind::kDegenerateCapture, "E-BOARDS-NOTFOUND",
                "no board was found in any of " + photographs + examples,
                std::string(request.kind ? "leave out --board or name another kind"
                                         : "say what the board is with --board") +
                    " (" + board_kind_names() +
                    "), and photograph it sharp, evenly lit and large in the picture");
}

}  // namespace

BoardPhotographs find_boards(const std::filesystem::path& folder, const BoardRequest& request,
                             int threads, Progress& progress) {
    const PhotographFolder listed = list_photographs(folder, {}, {});
    BoardPhotographs found;
    found.left_out = listed.left_out;
    ImageSize size;
    const std::vector<PhotographFile> files = readable_of_one_size(listed, size, found.left_out);
    found.photographs = files.size();
    if (files.empty()) {
        throw Error(ErrorKind::kBadInput, "E-BOARDS-NOPHOTOS",
                    folder.string() + " holds no photograph that can be read",
                    "give a folder with photographs of a calibration board");
    }
    const BoardKind kind =
        request.kind ? *request.kind : kind_in_sample(files, request, threads, progress);
    progress.begin("looking for the board", files.size());
    for (BoardAnswer& answer : answers_for(files, kind, request, threads, progress)) {
        if (answer.board) {
            found.detections.push_back(std::move(*answer.board));
        } else {
            found.left_out.push_back(std::move(answer.left_out));
        }
    }
    if (found.detections.empty()) refuse_without_board(found, request);
    found.kind = most_frequent_kind(found.detections);
    // A square lattice read as a hexagonal one, or the other way round, has another geometry.
    std::erase_if(found.detections, [&](const BoardDetection& detection) {
        if (is_hexagonal(detection.kind) == is_hexagonal(found.kind)) return false;
        found.left_out.push_back({detection.view.photograph, "E-BOARD-OTHER",
                                  "the circles are arranged as in " +
                                      std::string(name_of(detection.kind)) +
                                      ", unlike in the other photographs"});
        return true;
    });
    found.board.width_px = size.width_px;
    found.board.height_px = size.height_px;
    found.board.are_discs = found.kind == BoardKind::kCircles ||
                            found.kind == BoardKind::kAsymmetricCircles || is_hexagonal(found.kind);
    found.board.turns_alike = is_hexagonal(found.kind) ? 6 : 4;
    found.board.is_size_known = request.size_per_pitch > 0;
    found.board.size_per_pitch =
        found.board.is_size_known ? request.size_per_pitch : median_size(found.detections);
    for (const BoardDetection& detection : found.detections) {
        found.board.views.push_back(detection.view);
        const auto [less, more] = std::minmax(detection.columns, detection.rows);
        found.columns = std::max(found.columns, more);
        found.rows = std::max(found.rows, less);
    }
    found.warnings = doubts_of_size(found, request);
    return found;
}

}  // namespace lumi
