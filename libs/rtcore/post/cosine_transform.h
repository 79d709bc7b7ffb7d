/// The cosine transform of lines of any length: a filter that treats borders as mirrors is a product there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// Lines of complex numbers, which are transformed side by side: two real ones each, which do not mix.
inline constexpr std::size_t kTransformLines = 16;

/// Memory of one thread.
struct TransformScratch {
    std::vector<float> re, im;           ///< length x kTransformLines, value by value; in and out
    std::vector<float> otherRe, otherIm; ///< for the transform
    std::vector<float> longRe, longIm;   ///< for lengths with a large prime factor
};

/// DCT-II, X[k] = sum over n of x[n] cos(pi (2 n + 1) k / 2 N), and its inverse (DCT-III). By complex
/// transforms of length N (Makhoul 1980); these by factors up to 13 (Stockham's order), else as a convolution
/// (Bluestein 1970), so that the cost is N log N for any N. Float; the error is about 3e-7 of the largest.
/// Immutable once built: any number of threads, each with scratch of its own. The same bits on every
/// processor.
class CosineTransform {
  public:
    explicit CosineTransform(std::size_t length); ///< 1..2^20

    std::size_t length() const { return length_; }
    void prepare(TransformScratch& scratch) const; ///< makes it large enough; its content is undefined then
    void forward(TransformScratch& scratch) const;
    void inverse(TransformScratch& scratch) const;

    /// e^(-2 pi i k / n).
    struct Root {
        float re = 1, im = 0;
    };

  private:
    /// A complex transform by small factors.
    struct Plan {
        std::size_t length = 0;
        std::vector<std::size_t> factors;
        std::vector<Root> roots; ///< all `length` of them
    };
    static bool isSmooth(std::size_t length);
    static Plan planFor(std::size_t length);
    static void transform(const Plan& plan, std::vector<float>& re, std::vector<float>& im,
                          std::vector<float>& otherRe, std::vector<float>& otherIm);
    void transform(TransformScratch& scratch) const;
    void convolve(TransformScratch& scratch) const;

    std::size_t length_;
    Plan plan_;               ///< of length_, or of the convolution
    std::vector<Root> turns_; ///< e^(-pi i k / 2 N)
    std::vector<Root> chirp_; ///< e^(-pi i k^2 / N); empty where there is no convolution
    std::vector<Root> chirpTransform_;
};

} // namespace rtcore
