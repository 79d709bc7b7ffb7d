#include "made_net.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

namespace test {

namespace {

using rtcore::Tensor;
using rtcore::TensorArchive;

std::size_t index(const Features& f, int x, int y, int c) {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(f.width) + static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(f.channels) +
           static_cast<std::size_t>(c);
}

Features convolved(const TensorArchive& archive, const std::string& layer, const Features& in) {
    const Tensor& weights = archive.at(layer + ".weight");
    const Tensor& bias = archive.at(layer + ".bias");
    Features out(in.width, in.height, static_cast<int>(weights.sides[0]));
    for (int y = 0; y < in.height; ++y) {
        for (int x = 0; x < in.width; ++x) {
            for (int o = 0; o < out.channels; ++o) {
                double sum = static_cast<double>(bias.values[static_cast<std::size_t>(o)]);
                for (int i = 0; i < in.channels; ++i) {
                    for (int tap = 0; tap < 9; ++tap) {
                        const int u = x + tap % 3 - 1, v = y + tap / 3 - 1;
                        if (u < 0 || u >= in.width || v < 0 || v >= in.height) continue;
                        const auto w = static_cast<std::size_t>((o * in.channels + i) * 9 + tap);
                        sum += static_cast<double>(weights.values[w]) * in.at(u, v, i);
                    }
                }
                out.at(x, y, o) = std::max(sum, 0.0);
            }
        }
    }
    return out;
}

Features pooled(const Features& in) {
    Features out(in.width / 2, in.height / 2, in.channels);
    for (int y = 0; y < in.height; ++y)
        for (int x = 0; x < in.width; ++x)
            for (int c = 0; c < in.channels; ++c)
                out.at(x / 2, y / 2, c) = std::max(out.at(x / 2, y / 2, c), in.at(x, y, c)); // not below 0
    return out;
}

Features upsampledBeside(const Features& small, const Features& other) {
    Features out(other.width, other.height, small.channels + other.channels);
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            for (int c = 0; c < small.channels; ++c) out.at(x, y, c) = small.at(x / 2, y / 2, c);
            for (int c = 0; c < other.channels; ++c) out.at(x, y, small.channels + c) = other.at(x, y, c);
        }
    }
    return out;
}

std::vector<std::string> downLayers(int size, bool large) {
    const std::string number = std::to_string(size + 1);
    if (size == 4 || large) return {"enc_conv" + number + "a", "enc_conv" + number + "b"};
    return size == 0 ? std::vector<std::string>{"enc_conv0", "enc_conv1"}
                     : std::vector<std::string>{"enc_conv" + number};
}
std::vector<std::string> upLayers(int size, bool large) {
    const std::string number = std::to_string(size + 1);
    std::vector<std::string> layers{"dec_conv" + number + "a", "dec_conv" + number + "b"};
    if (size == 0) layers.emplace_back(large ? "dec_conv1c" : "dec_conv0");
    return layers;
}

template <typename T>
void append(std::vector<std::byte>& bytes, const T& value) {
    const auto* const first = reinterpret_cast<const std::byte*>(&value);
    bytes.insert(bytes.end(), first, first + sizeof value);
}

std::uint16_t halfOf(float value) { // of normal halves
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return static_cast<std::uint16_t>((bits >> 16U & 0x8000U) | (((bits >> 23U & 255U) - 112U) << 10U) |
                                      (bits >> 13U & 1023U));
}

} // namespace

Features::Features(int w, int h, int c)
    : width(w), height(h), channels(c),
      values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * static_cast<std::size_t>(c)) {}
double& Features::at(int x, int y, int c) { return values[index(*this, x, y, c)]; }
double Features::at(int x, int y, int c) const { return values[index(*this, x, y, c)]; }

TensorArchive madeNet(int inputs, bool large, int maxChannels) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> number(-1, 1);
    TensorArchive archive;
    int kept[5] = {inputs}, channels = inputs, next = 0;
    constexpr int kChannels[] = {17, 5, 33, 7, 20, 3};
    const auto nextChannels = [&] { return std::min(kChannels[next++ % 6], maxChannels); };
    const auto add = [&](const std::string& name, int from, int to) {
        Tensor weights{{static_cast<std::uint32_t>(to), static_cast<std::uint32_t>(from), 3, 3}, {}};
        Tensor bias{{static_cast<std::uint32_t>(to)}, {}};
        const float scale = std::sqrt(6.0F / (9.0F * static_cast<float>(from))); // (He et al. 2015)
        for (int i = 0; i < 9 * from * to; ++i) weights.values.push_back(scale * number(random));
        for (int i = 0; i < to; ++i) bias.values.push_back(0.1F * number(random));
        archive[name + ".weight"] = weights;
        archive[name + ".bias"] = bias;
        channels = to;
    };
    for (int size = 0; size < 5; ++size) {
        for (const std::string& layer : downLayers(size, large)) add(layer, channels, nextChannels());
        if (size < 4) kept[size + 1] = channels;
    }
    for (int size = 4; size-- > 0;) {
        const std::vector<std::string> layers = upLayers(size, large);
        for (const std::string& layer : layers) {
            const int from = &layer == &layers.front() ? channels + kept[size] : channels;
            add(layer, from, size == 0 && &layer == &layers.back() ? 3 : nextChannels());
        }
    }
    return archive;
}

std::vector<std::byte> archiveBytes(const TensorArchive& archive, bool halves) {
    std::vector<std::byte> bytes;
    append(bytes, std::uint16_t{0x41D7});
    append(bytes, std::uint8_t{2});
    append(bytes, std::uint8_t{0});
    append(bytes, std::uint64_t{0}); // where the table is: below
    std::vector<std::uint64_t> positions;
    for (const auto& [name, tensor] : archive) {
        bytes.resize((bytes.size() + 63) / 64 * 64);
        positions.push_back(bytes.size());
        for (const float value : tensor.values) halves ? append(bytes, halfOf(value)) : append(bytes, value);
    }
    const std::uint64_t table = bytes.size();
    std::memcpy(&bytes[4], &table, sizeof table);
    append(bytes, static_cast<std::uint32_t>(archive.size()));
    std::size_t i = 0;
    for (const auto& [name, tensor] : archive) {
        append(bytes, static_cast<std::uint16_t>(name.size()));
        for (const char letter : name) append(bytes, letter);
        append(bytes, static_cast<std::uint8_t>(tensor.sides.size()));
        for (const std::uint32_t side : tensor.sides) append(bytes, side);
        for (const char letter : std::string(tensor.sides.size() == 1 ? "x" : "oihw")) append(bytes, letter);
        append(bytes, halves ? 'h' : 'f');
        append(bytes, positions[i++]);
    }
    return bytes;
}

Features evaluate(const TensorArchive& archive, const Features& input) {
    const bool large = archive.contains("enc_conv1b.weight");
    std::vector<Features> kept{input};
    Features x = input;
    for (int size = 0; size < 5; ++size) {
        for (const std::string& layer : downLayers(size, large)) x = convolved(archive, layer, x);
        if (size < 4) kept.push_back(x = pooled(x));
    }
    for (int size = 4; size-- > 0;) {
        x = upsampledBeside(x, kept[static_cast<std::size_t>(size)]);
        for (const std::string& layer : upLayers(size, large)) x = convolved(archive, layer, x);
    }
    return x;
}

Features randomInput(int width, int height, int channels) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> number(0, 1);
    Features input(width, height, channels);
    for (double& value : input.values) value = static_cast<double>(number(random));
    return input;
}

std::vector<float> outputOf(const std::shared_ptr<const rtcore::UNet>& net, const Features& input,
                            int threads, const std::atomic<bool>* stop) {
    std::vector<float> output(static_cast<std::size_t>(input.width * input.height * 3), -1);
    const rtcore::UNetRun::Rows rows{
        [&](int y, int left, int count, float* pixels) {
            for (int i = 0; i < count; ++i)
                for (int c = 0; c < rtcore::UNetRun::kStride; ++c)
                    pixels[i * rtcore::UNetRun::kStride + c] =
                        c < input.channels ? static_cast<float>(input.at(left + i, y, c)) : 0;
        },
        [&](int y, int left, int count, const float* pixels) {
            for (int i = 0; i < count; ++i)
                for (int c = 0; c < 3; ++c)
                    output[static_cast<std::size_t>((y * input.width + left + i) * 3 + c)] =
                        pixels[i * rtcore::UNetRun::kStride + c];
        }};
    const bool done = rtcore::UNetRun(net).run(input.width, input.height, rows, threads, stop);
    return done ? output : std::vector<float>();
}

} // namespace test
