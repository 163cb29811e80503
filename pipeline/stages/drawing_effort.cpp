#include "pipeline/stages/drawing_effort.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "calib/work/counted.h"
#include "pipeline/text/number_text.h"

namespace lumi {

using Json = nlohmann::ordered_json;

namespace {

/// The beginning of what was measured on them.
std::string drawn_photographs(int pictures) {
    return counted(pictures, "photograph") + (pictures == 1 ? " is drawn " : " are drawn ");
}

/// A gain in words, with its standard error where there is one; one that rounds to none is none.
std::string gain_text(double gain_db, std::optional<double> standard_error_db = std::nullopt) {
    const std::string amount = number_text(std::abs(gain_db), 2);
    const bool is_loss = gain_db < 0 && amount != number_text(0, 2);
    return amount + (standard_error_db ? " +- " + number_text(*standard_error_db, 2) : "") +
           (is_loss ? " dB worse" : " dB better");
}

/// What eyes say that look from elsewhere, where they were asked.
std::string moved_text(double know_more) {
    if (know_more == 0) return "";
    return "by which eyes a third nearer and farther know " + number_text(100 * know_more, 1) +
           " % more of their pictures, ";
}

}  // namespace

void choose(const OcclusionEffort& effort, DrawingChoices& drawing) {
    drawing.occlusion_tolerance_px = effort.tolerance_px;
}

void choose(const DepthEffort& effort, DrawingChoices& drawing) {
    drawing.depth_views = effort.views;
    drawing.depth_block_px = effort.block_px;
    drawing.fills_holes = effort.fills_holes;
    drawing.checks_guesses = effort.checks_guesses;
}

void choose(const TriangleEffort& effort, DrawingChoices& drawing) {
    drawing.triangle_error_px = effort.error_px;
    drawing.draws_thin = effort.draws_thin;
}

void choose(const DrawingEfforts& efforts, DrawingChoices& drawing) {
    choose(efforts.occlusion, drawing);
    choose(efforts.depth, drawing);
    choose(efforts.triangles, drawing);
}

std::string text_of_depth_blocks(double block_px) {
    if (block_px >= kMaxDepthBlock_px) return "each block of 2 by 2 pixels";
    return "each pixel, or block of 2 by 2 in frames " +
           number_text(kMaxDepthBlock_px / block_px, 2) + " times as fine as the photographs";
}

std::string text_of(const DepthEffort& effort) {
    if (effort.pictures == 0) return "";
    return std::to_string(effort.views) + " views' depth is compared at " +
           text_of_depth_blocks(effort.block_px) + ": " + drawn_photographs(effort.pictures) +
           gain_text(effort.fewer_views_lose_db, effort.standard_error_db) + " with " +
           std::to_string(kMaxDepthViews) + " views than with " + std::to_string(kLeastDepthViews) +
           ", " + gain_text(effort.blocks_lose_db) + " pixel by pixel, " +
           gain_text(effort.holes_lose_db) + " with what these do not see drawn from others, " +
           moved_text(effort.moved_know_more) + "which is " + (effort.fills_holes ? "" : "not ") +
           "done" + ", and " + gain_text(effort.guesses_lose_db) + " with guesses " +
           (effort.checks_guesses ? "checked, which is done" : "checked, which is not done");
}

std::string text_of(const DepthMeshEffort& effort) {
    if (effort.pictures == 0) return "";
    return "depth is followed to " + number_text(effort.noisy_error_px, 2) +
           " px where its samples tell noise: " + drawn_photographs(effort.pictures) +
           gain_text(effort.coarsest_lose_db, effort.standard_error_db) +
           " with the finest meshes than with " + number_text(kNoisyDepthError_px, 1) +
           " px, and " + gain_text(effort.loses_db) + " than so";
}

std::string text_of(const OcclusionEffort& effort) {
    if (effort.pictures == 0) return "";
    return "views are blended unless they see something else by " +
           number_text(effort.tolerance_px, 1) + " px: " + drawn_photographs(effort.pictures) +
           gain_text(effort.gains_db, effort.standard_error_db) + " than with " +
           number_text(effort.beside_px, 1);
}

std::string text_of(const TriangleEffort& effort) {
    if (effort.pictures == 0) return "";
    const std::string of_error =
        effort.triangles > 0 ? "with " + std::to_string(std::lround(effort.triangles)) +
                                   " of them, and at best " + gain_text(effort.loses_db) + ", and "
                             : "";
    return "triangles may err by " + number_text(effort.error_px, 2) +
           " px: " + drawn_photographs(effort.pictures) + of_error +
           gain_text(effort.thin_gains_db, effort.thin_standard_error_db) +
           " with what is thinner drawn over them, " +
           (effort.draws_thin ? "which is done" : "which is not done");
}

Json json_of(const DepthEffort& effort) {
    return {{"views", effort.views},
            {"block_px", effort.block_px},
            {"fills_holes", effort.fills_holes},
            {"checks_guesses", effort.checks_guesses},
            {"pictures", effort.pictures},
            {"fewer_views_lose_db", effort.fewer_views_lose_db},
            {"standard_error_db", effort.standard_error_db},
            {"blocks_lose_db", effort.blocks_lose_db},
            {"holes_lose_db", effort.holes_lose_db},
            {"moved_know_more", effort.moved_know_more},
            {"guesses_lose_db", effort.guesses_lose_db}};
}

Json json_of(const DepthMeshEffort& effort) {
    return {{"noisy_error_px", effort.noisy_error_px},
            {"pictures", effort.pictures},
            {"coarsest_lose_db", effort.coarsest_lose_db},
            {"standard_error_db", effort.standard_error_db},
            {"loses_db", effort.loses_db}};
}

Json json_of(const OcclusionEffort& effort) {
    return {{"tolerance_px", effort.tolerance_px},
            {"pictures", effort.pictures},
            {"beside_px", effort.beside_px},
            {"gains_db", effort.gains_db},
            {"standard_error_db", effort.standard_error_db}};
}

Json json_of(const TriangleEffort& effort) {
    return {{"error_px", effort.error_px},
            {"pictures", effort.pictures},
            {"loses_db", effort.loses_db},
            {"triangles", effort.triangles},
            {"draws_thin", effort.draws_thin},
            {"thin_gains_db", effort.thin_gains_db},
            {"thin_standard_error_db", effort.thin_standard_error_db}};
}

}  // namespace lumi
