#include "pipeline/commands/video_file.h"

#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "calib/pictures/image_io.h"
#include "calib/work/child_process.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/commands/frame_files.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr const char* kAdvice =
    "install ffmpeg, or let --out name a folder: frames become PNG files";
constexpr const char* kEncoder = "ffmpeg";
constexpr const char* kCounter = "ffprobe";
/// Both lie beside the frames until the video is put in place.
constexpr const char* kMadeName = "video.mp4";
constexpr const char* kLogName = "video.log";
/// Nothing ends later, but what hangs.
constexpr double kStartLimit_s = 600;
constexpr double kFrameLimit_s = 10;
constexpr double kVersionLimit_s = 60;
constexpr const char* kConstantQuality = "18";  // Visually lossless for most pictures.

[[noreturn]] void refuse(const fs::path& video, const std::string& reason) {
    throw Error(ErrorKind::kExternalProgram, "E-VIDEO-WRITE", video.string() + ": " + reason,
                kAdvice);
}

/// ffmpeg reads its pattern in all of a path.
std::string as_pattern(const fs::path& folder) {
    std::string pattern;
    for (const char c : folder.string()) pattern += c == '%' ? "%%" : std::string(1, c);
    return pattern;
}

/// What the program printed. Throws Error (E-VIDEO-WRITE) when it did not end well.
std::string output_of(std::vector<std::string> arguments, std::size_t frames, const fs::path& log,
                      const fs::path& video, const Progress& progress) {
    ChildCommand command;
    command.arguments = std::move(arguments);
    command.time_limit_s = kStartLimit_s + kFrameLimit_s * static_cast<double>(frames);
    command.log_path = log;
    command.missing_advice = kAdvice;
    const ChildResult result = run_child(command, progress);
    std::string output = read_whole_text(log);
    if (result.end != ChildEnd::kExited || result.exit_status != 0)
        refuse(video, command.arguments.front() + " ended with " + description_of(result, command) +
                          ": " + output);
    return output;
}

/// Makes frames what H.264 takes: both sides even, as 4:2:0 halves colour, and of BT.709's matrix.
/// Black pixels at an odd side would darken the colour of those next to them.
std::string filters_for(const ImageSize& frame) {
    const int right = frame.width_px % 2;
    const int bottom = frame.height_px % 2;
    std::string filters = "format=gbrp";
    if (right + bottom > 0)
        filters += ",pad=" + std::to_string(frame.width_px + right) + ":" +
                   std::to_string(frame.height_px + bottom) +
                   ",fillborders=right=" + std::to_string(right) +
                   ":bottom=" + std::to_string(bottom) + ":mode=smear";
    return filters + ",scale=out_color_matrix=bt709:out_range=tv,format=yuv420p";
}

void encode(const fs::path& frames_folder, std::size_t count, double frames_per_second,
            const fs::path& video, const Progress& progress) {
    const fs::path made = frames_folder / kMadeName;
    const fs::path log = frames_folder / kLogName;
    output_of({kEncoder,
               "-nostdin",
               "-y",
               "-loglevel",
               "error",
               "-framerate",
               std::to_string(frames_per_second),
               "-start_number",
               "1",
               "-i",
               as_pattern(frames_folder) + "/frame-%06d.png",
               "-vf",
               filters_for(read_image_size(frames_folder / sequence_frame_name(0))),
               "-c:v",
               "libx264",
               "-crf",
               kConstantQuality,
               "-colorspace",
               "bt709",
               "-color_primaries",
               "bt709",
               "-color_trc",
               "iec61966-2-1",
               "-color_range",
               "tv",
               "-movflags",
               "+faststart",
               made.string()},
              count, log, video, progress);
    // An exit status is no evidence.
    const std::string counted =
        output_of({kCounter, "-v", "error", "-count_packets", "-select_streams", "v:0",
                   "-show_entries", "stream=nb_read_packets", "-of", "csv=p=0", made.string()},
                  count, log, video, progress);
    if (counted != std::to_string(count) + "\n")
        refuse(video, "ffmpeg made a video of \"" + counted.substr(0, counted.find('\n')) +
                          "\" frames of " + std::to_string(count));
    put_whole_file(made, video);
}

/// The same error, with the place where the frames stay. Where they cannot stay either, as on a
/// full disk, that is all there is to say.
Error with_kept_frames(const Error& error, WholeFolder& frames, const fs::path& video) {
    std::error_code ignored;
    fs::remove(frames.staging() / kMadeName, ignored);
    fs::remove(frames.staging() / kLogName, ignored);
    try {
        frames.put_in_place();
    } catch (const Error&) {
        return error;
    }
    const std::string folder = frames_folder_of_video(video).string();
    return {error.kind(), error.code(),
            std::string(error.what()) + "; its frames were kept as PNG files in " + folder,
            "make a video of the files in " + folder + ", or remove that folder"};
}

}  // namespace

void check_video_programs(const fs::path& video, const Progress& progress) {
    for (const char* program : {kEncoder, kCounter}) {
        ChildCommand command;
        command.arguments = {program, "-version"};
        command.time_limit_s = kVersionLimit_s;
        command.log_path = "/dev/null";
        command.missing_advice = kAdvice;
        const ChildResult result = run_child(command, progress);
        if (result.end != ChildEnd::kExited || result.exit_status != 0)
            refuse(video, command_line_of(command.arguments) + " ended with " +
                              description_of(result, command));
    }
}

void write_video(WholeFolder& frames, std::size_t count, double frames_per_second,
                 const fs::path& video, const Progress& progress) {
    try {
        encode(frames.staging(), count, frames_per_second, video, progress);
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::kInterrupted) throw;
        throw with_kept_frames(error, frames, video);
    }
}

}  // namespace lumi
