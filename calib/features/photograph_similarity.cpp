#include "calib/features/photograph_similarity.h"

#include <algorithm>

namespace lumi {
namespace {

/// One descriptor a column.
Eigen::MatrixXf largest_descriptors(const Features& features, int count) {
    const auto columns =
        std::min<Eigen::Index>(count, static_cast<Eigen::Index>(features.descriptors.size()));
    Eigen::MatrixXf result(kDescriptorSize, columns);
    for (Eigen::Index column = 0; column < columns; ++column) {
        const Descriptor& descriptor = features.descriptors[static_cast<std::size_t>(column)];
        for (Eigen::Index bin = 0; bin < kDescriptorSize; ++bin) {
            result(bin, column) = static_cast<float>(descriptor[static_cast<std::size_t>(bin)]);
        }
    }
    return result;
}

/// The nearest word of each descriptor.
std::vector<Eigen::Index> nearest_words(const Eigen::MatrixXf& words,
                                        const Eigen::MatrixXf& descriptors) {
    const Eigen::VectorXf half_length = 0.5F * words.colwise().squaredNorm().transpose();
    const Eigen::MatrixXf products = words.transpose() * descriptors;
    std::vector<Eigen::Index> nearest(static_cast<std::size_t>(descriptors.cols()));
    for (Eigen::Index column = 0; column < descriptors.cols(); ++column) {
        (products.col(column) - half_length).maxCoeff(&nearest[static_cast<std::size_t>(column)]);
    }
    return nearest;
}

/// Descriptors from all over the photographs, evenly spaced.
Eigen::MatrixXf sample_of(const std::vector<Eigen::MatrixXf>& descriptors) {
    constexpr Eigen::Index kSample = 20000;
    Eigen::Index total = 0;
    for (const Eigen::MatrixXf& of_one : descriptors) total += of_one.cols();
    const Eigen::Index step = 1 + total / kSample;
    Eigen::MatrixXf sample(kDescriptorSize, (total + step - 1) / step);
    Eigen::Index position = 0;
    for (const Eigen::MatrixXf& of_one : descriptors) {
        for (Eigen::Index column = 0; column < of_one.cols(); ++column, ++position) {
            if (position % step == 0) sample.col(position / step) = of_one.col(column);
        }
    }
    return sample;
}

/// k-means; a word that nothing is nearest to stays where it is.
Eigen::MatrixXf vocabulary_of(const Eigen::MatrixXf& sample,
                              const PhotographSimilarityOptions& options) {
    const Eigen::Index count = std::min<Eigen::Index>(options.words, sample.cols());
    Eigen::MatrixXf words(kDescriptorSize, count);
    for (Eigen::Index word = 0; word < count; ++word) {
        words.col(word) = sample.col(word * sample.cols() / count);
    }
    for (int round = 0; round < options.rounds; ++round) {
        const std::vector<Eigen::Index> nearest = nearest_words(words, sample);
        Eigen::MatrixXf sum = Eigen::MatrixXf::Zero(kDescriptorSize, count);
        Eigen::VectorXf members = Eigen::VectorXf::Zero(count);
        for (std::size_t index = 0; index < nearest.size(); ++index) {
            sum.col(nearest[index]) += sample.col(static_cast<Eigen::Index>(index));
            members[nearest[index]] += 1;
        }
        for (Eigen::Index word = 0; word < count; ++word) {
            if (members[word] > 0) words.col(word) = sum.col(word) / members[word];
        }
    }
    return words;
}

Eigen::VectorXf vlad_of(const Eigen::MatrixXf& words, const Eigen::MatrixXf& descriptors) {
    const std::vector<Eigen::Index> nearest = nearest_words(words, descriptors);
    Eigen::MatrixXf residuals = Eigen::MatrixXf::Zero(words.rows(), words.cols());
    for (std::size_t index = 0; index < nearest.size(); ++index) {
        residuals.col(nearest[index]) +=
            descriptors.col(static_cast<Eigen::Index>(index)) - words.col(nearest[index]);
    }
    for (Eigen::Index word = 0; word < residuals.cols(); ++word) {
        const float length = residuals.col(word).norm();
        if (length > 0) residuals.col(word) /= length;
    }
    Eigen::VectorXf vlad = residuals.reshaped();
    const float length = vlad.norm();
    if (length > 0) vlad /= length;
    return vlad;
}

}  // namespace

Eigen::MatrixXf photograph_similarity(const std::vector<Features>& photographs,
                                      const PhotographSimilarityOptions& options) {
    const auto count = static_cast<Eigen::Index>(photographs.size());
    std::vector<Eigen::MatrixXf> descriptors;
    for (const Features& features : photographs) {
        descriptors.push_back(largest_descriptors(features, options.features));
    }
    const Eigen::MatrixXf sample = sample_of(descriptors);
    if (sample.cols() == 0) return Eigen::MatrixXf::Zero(count, count);
    const Eigen::MatrixXf words = vocabulary_of(sample, options);
    Eigen::MatrixXf vlads(words.size(), count);
    for (Eigen::Index index = 0; index < count; ++index) {
        vlads.col(index) = vlad_of(words, descriptors[static_cast<std::size_t>(index)]);
    }
    return vlads.transpose() * vlads;
}

}  // namespace lumi
