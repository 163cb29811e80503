#include "calib/ingest/video_decoder.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/display.h>
#include <libswscale/swscale.h>
}

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

[[noreturn]] void refuse_video(const std::filesystem::path& video) {
    throw Error(ErrorKind::kBadInput, "E-INGEST-NOVIDEO",
                video.string() + ": not a video that can be read",
                "give a folder of photographs, or a video that a player can show");
}

double seconds(std::int64_t time, AVRational unit) {
    return time == AV_NOPTS_VALUE ? 0.0 : static_cast<double>(time) * av_q2d(unit);
}

double rotation_deg_of(const AVStream& stream) {
    const std::uint8_t* matrix =
        av_stream_get_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, nullptr);
    if (matrix == nullptr) return 0.0;
    // FFmpeg counts against the clock.
    const double clockwise_deg = -av_display_rotation_get(reinterpret_cast<const int*>(matrix));
    return std::isfinite(clockwise_deg) ? std::fmod(clockwise_deg + 360.0, 360.0) : 0.0;
}

std::optional<CodedColors> coded_colors_of(const AVCodecParameters& parameters) {
    const bool says_nothing = parameters.color_primaries == AVCOL_PRI_UNSPECIFIED &&
                              parameters.color_trc == AVCOL_TRC_UNSPECIFIED;
    if (says_nothing) return std::nullopt;
    // FFmpeg numbers them as ITU-T H.273 does.
    return CodedColors{parameters.color_primaries, parameters.color_trc};
}

/// The stream's is without what an edit list cuts off; the file's counts sound, too. Of an AVI that
/// ends early both are what is left, and only its header tells how many frames there were.
double duration_s_of(const AVFormatContext& format, const AVStream& stream) {
    const bool is_avi = std::string_view(format.iformat->name) == "avi";
    if (is_avi && stream.nb_frames > 0 && stream.avg_frame_rate.num > 0) {
        return static_cast<double>(stream.nb_frames) / av_q2d(stream.avg_frame_rate);
    }
    const double of_stream_s = seconds(stream.duration, stream.time_base);
    if (of_stream_s > 0) return of_stream_s;
    return std::max(0.0, seconds(format.duration, {1, AV_TIME_BASE}));
}

VideoFacts facts_of(const AVFormatContext& format, const AVStream& stream) {
    VideoFacts facts;
    facts.rotation_deg = rotation_deg_of(stream);
    facts.duration_s = duration_s_of(format, stream);
    const double frames_per_s = av_q2d(stream.avg_frame_rate);
    if (stream.avg_frame_rate.den != 0 && frames_per_s > 0) {
        facts.frames = static_cast<std::size_t>(std::lround(facts.duration_s * frames_per_s));
    }
    facts.coded = coded_colors_of(*stream.codecpar);
    return facts;
}

/// A pixel format that stands for a range of its own, as JPEG's, and the one it is but for that.
std::optional<AVPixelFormat> format_of_full_range(int format) {
    constexpr std::array<std::array<AVPixelFormat, 2>, 5> kFormats{{
        {AV_PIX_FMT_YUVJ420P, AV_PIX_FMT_YUV420P},
        {AV_PIX_FMT_YUVJ422P, AV_PIX_FMT_YUV422P},
        {AV_PIX_FMT_YUVJ444P, AV_PIX_FMT_YUV444P},
        {AV_PIX_FMT_YUVJ440P, AV_PIX_FMT_YUV440P},
        {AV_PIX_FMT_YUVJ411P, AV_PIX_FMT_YUV411P},
    }};
    for (const auto& [of_full_range, plain] : kFormats) {
        if (format == of_full_range) return plain;
    }
    return std::nullopt;
}

/// The matrix, as H.273 numbers it.
int matrix_of(const AVFrame& frame, bool is_jpeg) {
    constexpr int kLeastLinesOfHighDefinition = 720;
    if (frame.colorspace != AVCOL_SPC_UNSPECIFIED) return frame.colorspace;
    const int lines = std::min(frame.width, frame.height);
    return !is_jpeg && lines >= kLeastLinesOfHighDefinition ? AVCOL_SPC_BT709 : AVCOL_SPC_SMPTE170M;
}

}  // namespace

class VideoDecoder::Stream {
 public:
    explicit Stream(const std::filesystem::path& video) : path_(video) {
        av_log_set_level(AV_LOG_QUIET);  // What is wrong with a file is said in lumi's words.
        AVFormatContext* format = nullptr;
        // Or else a name with a colon would be an address.
        const std::string address = "file:" + video.string();
        if (avformat_open_input(&format, address.c_str(), nullptr, nullptr) < 0) {
            refuse_video(video);
        }
        format_.reset(format);
        if (avformat_find_stream_info(format, nullptr) < 0) refuse_video(video);
        const AVCodec* decoder = nullptr;
        index_ = av_find_best_stream(format, AVMEDIA_TYPE_VIDEO, -1, -1, &decoder, 0);
        if (index_ < 0 || decoder == nullptr) refuse_video(video);
        AVStream& stream = *format->streams[index_];
        codec_.reset(avcodec_alloc_context3(decoder));
        codec_->thread_count = 0;  // As many as there are cores.
        if (avcodec_parameters_to_context(codec_.get(), stream.codecpar) < 0 ||
            avcodec_open2(codec_.get(), decoder, nullptr) < 0) {
            refuse_video(video);
        }
        facts_ = facts_of(*format, stream);
    }

    [[nodiscard]] const VideoFacts& facts() const { return facts_; }

    [[nodiscard]] bool next() {
        do {
            if (!decode()) return false;
        } while (is_damaged());
        take_time();
        return true;
    }

    [[nodiscard]] double time_s() const { return time_s_; }

    [[nodiscard]] ColorImage picture() {
        const ImageSize size = size_of_square_pixels();
        ColorImage picture(size.width_px, size.height_px);
        convert(color_scaler_, AV_PIX_FMT_RGB24, size,
                reinterpret_cast<std::uint8_t*>(picture.row(0)), 3 * size.width_px);
        return picture;
    }

    [[nodiscard]] GrayImage brightness() {
        GrayImage picture(frame_->width, frame_->height);
        convert(gray_scaler_, AV_PIX_FMT_GRAY8, {frame_->width, frame_->height}, picture.row(0),
                frame_->width);
        return picture;
    }

 private:
    /// The next frame; packets that cannot be decoded are passed over.
    [[nodiscard]] bool decode() {
        while (true) {
            const int status = avcodec_receive_frame(codec_.get(), frame_.get());
            if (status >= 0) return true;
            if (status != AVERROR(EAGAIN)) return false;
            send_packet();
        }
    }

    /// At the end of the file, that it has come.
    void send_packet() {
        while (av_read_frame(format_.get(), packet_.get()) >= 0) {
            const bool is_of_stream = packet_->stream_index == index_;
            const bool is_taken =
                is_of_stream && avcodec_send_packet(codec_.get(), packet_.get()) >= 0;
            av_packet_unref(packet_.get());
            if (is_taken) return;
        }
        avcodec_send_packet(codec_.get(), nullptr);
    }

    /// Without a time stamp, by the rate.
    void take_time() {
        const AVStream& stream = *format_->streams[index_];
        if (const std::int64_t time = frame_->best_effort_timestamp; time != AV_NOPTS_VALUE) {
            if (!start_) start_ = time;
            time_s_ = seconds(time - *start_, stream.time_base);
        } else if (stream.avg_frame_rate.num > 0) {
            time_s_ += 1.0 / av_q2d(stream.avg_frame_rate);
        }
    }

    [[nodiscard]] bool is_damaged() const {
        return (frame_->flags & AV_FRAME_FLAG_CORRUPT) != 0 || frame_->decode_error_flags != 0;
    }

    /// Of the frame when the side along which its pixels are longer is stretched, and nothing lost.
    [[nodiscard]] ImageSize size_of_square_pixels() {
        constexpr double kMostStretch = 4.0;  // No tape or telephone has more: a damaged header.
        // Nor less, unless none: what rounding a picture's shape to that of a screen leaves.
        constexpr double kLeastStretch = 0.005;
        const double shape = av_q2d(
            av_guess_sample_aspect_ratio(format_.get(), format_->streams[index_], frame_.get()));
        const bool is_stretched =
            shape > 1 / kMostStretch && shape < kMostStretch && std::abs(shape - 1) > kLeastStretch;
        if (!is_stretched) return {frame_->width, frame_->height};
        const auto stretched = [](int side_px, double factor) {
            return static_cast<int>(std::lround(side_px * std::max(1.0, factor)));
        };
        return {stretched(frame_->width, shape), stretched(frame_->height, 1 / shape)};
    }

    struct FreeScaler {
        void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
    };
    using Scaler = std::unique_ptr<SwsContext, FreeScaler>;

    void convert(Scaler& scaler, AVPixelFormat to, ImageSize size, std::uint8_t* rows,
                 int bytes_per_row) {
        const auto of_full_range = format_of_full_range(frame_->format);
        const auto from = of_full_range.value_or(static_cast<AVPixelFormat>(frame_->format));
        constexpr int kExact = SWS_BICUBIC | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT;
        scaler.reset(sws_getCachedContext(scaler.release(), frame_->width, frame_->height, from,
                                          size.width_px, size.height_px, to, kExact, nullptr,
                                          nullptr, nullptr));
        if (!scaler) refuse_video(path_);
        const bool is_full_range = of_full_range || frame_->color_range == AVCOL_RANGE_JPEG;
        const int* matrix = sws_getCoefficients(matrix_of(*frame_, of_full_range.has_value()));
        constexpr int kUnchanged = 1 << 16;
        // What is RGB already has no matrix, and says so by failing.
        sws_setColorspaceDetails(scaler.get(), matrix, is_full_range ? 1 : 0, matrix, 1, 0,
                                 kUnchanged, kUnchanged);
        if (sws_scale(scaler.get(), frame_->data, frame_->linesize, 0, frame_->height, &rows,
                      &bytes_per_row) != size.height_px) {
            refuse_video(path_);
        }
    }

    struct CloseFormat {
        void operator()(AVFormatContext* format) const { avformat_close_input(&format); }
    };
    struct FreeCodec {
        void operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
    };
    struct FreePacket {
        void operator()(AVPacket* packet) const { av_packet_free(&packet); }
    };
    struct FreeFrame {
        void operator()(AVFrame* frame) const { av_frame_free(&frame); }
    };

    std::unique_ptr<AVFormatContext, CloseFormat> format_;
    std::unique_ptr<AVCodecContext, FreeCodec> codec_;
    std::unique_ptr<AVPacket, FreePacket> packet_{av_packet_alloc()};
    std::unique_ptr<AVFrame, FreeFrame> frame_{av_frame_alloc()};
    Scaler color_scaler_;
    Scaler gray_scaler_;
    std::filesystem::path path_;
    int index_ = -1;
    std::optional<std::int64_t> start_;
    double time_s_ = 0.0;
    VideoFacts facts_;
};

VideoDecoder::VideoDecoder(const std::filesystem::path& video)
    : stream_(std::make_unique<Stream>(video)) {}

VideoDecoder::~VideoDecoder() = default;

const VideoFacts& VideoDecoder::facts() const { return stream_->facts(); }

bool VideoDecoder::next() { return stream_->next(); }

double VideoDecoder::time_s() const { return stream_->time_s(); }

ColorImage VideoDecoder::picture() { return stream_->picture(); }

GrayImage VideoDecoder::brightness() { return stream_->brightness(); }

}  // namespace lumi
