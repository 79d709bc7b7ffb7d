/// Archives as 3MF files are, made by the tests.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace test {

class ZipWriter {
  public:
    void add(std::string_view name, std::string_view bytes, bool packed = true) {
        const std::string body = packed ? deflated(bytes) : std::string(bytes);
        const auto crc = static_cast<std::uint32_t>(
            crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
        const std::string common = number(20, 2) + number(0, 2) + number(packed ? 8 : 0, 2) + number(0, 4) +
                                   number(crc, 4) + number(body.size(), 4) + number(bytes.size(), 4) +
                                   number(name.size(), 2) + number(0, 2);
        contents_ += "PK\x01\x02" + number(20, 2) + common + number(0, 2) + number(0, 2) + number(0, 2) +
                     number(0, 4) + number(file_.size(), 4) + std::string(name);
        file_ += "PK\x03\x04" + common + std::string(name) + body;
        ++count_;
    }

    std::string text() const {
        return file_ + contents_ + "PK\x05\x06" + number(0, 4) + number(count_, 2) + number(count_, 2) +
               number(contents_.size(), 4) + number(file_.size(), 4) + number(0, 2);
    }

  private:
    static std::string number(std::uint64_t value, int bytes) {
        std::string text;
        for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xFFU);
        return text;
    }
    static std::string deflated(std::string_view bytes) {
        z_stream stream{};
        if (deflateInit2(&stream, 9, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY) != Z_OK)
            throw std::runtime_error("deflate");
        std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
        stream.avail_in = static_cast<uInt>(bytes.size());
        stream.next_out = reinterpret_cast<Bytef*>(packed.data());
        stream.avail_out = static_cast<uInt>(packed.size());
        if (deflate(&stream, Z_FINISH) != Z_STREAM_END) throw std::runtime_error("deflate");
        packed.resize(stream.total_out);
        deflateEnd(&stream);
        return packed;
    }

    std::string file_, contents_;
    std::uint64_t count_ = 0;
};

} // namespace test
