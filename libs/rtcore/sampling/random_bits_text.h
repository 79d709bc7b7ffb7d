// Random numbers by name over 32 bits of type RT_BITS: the text of functions, included inside a namespace
// with RT_FORMULA defined as what precedes each. sample_id.h includes it for std::uint32_t, owen-inl.h for
// Uint once for each instruction set. Hence no guard.

/// Well mixed bits of 32 others (Wellons' lowbias32, 2018): a bijection.
RT_FORMULA RT_BITS mixBits(RT_BITS x) {
    x = x ^ x >> 16;
    x = x * RT_BITS(0x7FEB352DU);
    x = x ^ x >> 15;
    x = x * RT_BITS(0x846CA68BU);
    return x ^ x >> 16;
}

/// The highest bit becomes the lowest.
RT_FORMULA RT_BITS reversedBits(RT_BITS x) {
    x = x >> 16 | x << 16;
    x = (x >> 8 & RT_BITS(0x00FF00FFU)) | (x & RT_BITS(0x00FF00FFU)) << 8;
    x = (x >> 4 & RT_BITS(0x0F0F0F0FU)) | (x & RT_BITS(0x0F0F0F0FU)) << 4;
    x = (x >> 2 & RT_BITS(0x33333333U)) | (x & RT_BITS(0x33333333U)) << 2;
    return (x >> 1 & RT_BITS(0x55555555U)) | (x & RT_BITS(0x55555555U)) << 1;
}

/// Owen's scrambling of a fraction whose bits are those of `reversed` backwards: each bit is flipped or not
/// by a hash of the bits above it and of the seed (Laine and Karras 2011; the constants are Vegdahl's, 2021).
RT_FORMULA RT_BITS owenOfReversed(RT_BITS reversed, RT_BITS seed) {
    RT_BITS x = reversed + seed;
    x = x ^ x * RT_BITS(0x6C50B47CU);
    x = x ^ x * RT_BITS(0xB82F1E52U);
    x = x ^ x * RT_BITS(0xC7AFE638U);
    x = x ^ x * RT_BITS(0x8D22F6E6U);
    return reversedBits(x);
}

/// A permutation of the numbers below 2^32 that keeps each interval of 2^-k of them an interval of 2^-k.
RT_FORMULA RT_BITS owenScrambled(RT_BITS x, RT_BITS seed) { return owenOfReversed(reversedBits(x), seed); }

/// The second coordinate of point i of Sobol's sequence, with its bits reversed; the first is i itself. The
/// matrix is Pascal's triangle modulo 2: bit j of the result is the sum of the bits k of i with k & j = j.
RT_FORMULA RT_BITS reversedSobol(RT_BITS i) {
    i = i ^ (i >> 1 & RT_BITS(0x55555555U));
    i = i ^ (i >> 2 & RT_BITS(0x33333333U));
    i = i ^ (i >> 4 & RT_BITS(0x0F0F0F0FU));
    i = i ^ (i >> 8 & RT_BITS(0x00FF00FFU));
    return i ^ i >> 16;
}

/// A point of the unit square in units of 2^-32.
struct OwenPair {
    RT_BITS u, v;
};

/// Point i of a pair of dimensions named `name`, which is well mixed: the shuffled and scrambled first two
/// dimensions of Sobol's sequence (Burley 2020, "Practical Hash-based Owen Scrambling"). Points 0 to 2^k - 1
/// of one name are a (0, k, 2)-net; those of different names are independent.
RT_FORMULA OwenPair owenPair(RT_BITS i, RT_BITS name) {
    const RT_BITS shuffled = owenScrambled(i, name);
    return {owenOfReversed(shuffled, mixBits(name + RT_BITS(0x9E3779B9U))),
            owenOfReversed(reversedSobol(shuffled), mixBits(name + RT_BITS(0x85EBCA6BU)))};
}

/// The name of a pixel's numbers, x | y << 16, in images with this seed.
RT_FORMULA RT_BITS nameOfPixel(RT_BITS xy, RT_BITS seed) {
    return mixBits(mixBits(xy) + RT_BITS(0x9E3779B9U) * seed);
}

/// The name of what the paths of a pixel use numbers for. `use`: the dimension in the upper 8 bits, the
/// bounce in the others.
RT_FORMULA RT_BITS nameOfUse(RT_BITS pixel, RT_BITS use) { return mixBits(pixel ^ use); }
