// Three numbers of any type: the text of a template, included inside a namespace with RT_FORMULA defined as
// what precedes each function. math/vec.h includes it for float and double; float3-inl.h once for each
// instruction set, since compilers inline no function of one set into a template that was compiled for
// another. Hence no guard.

template <typename T>
struct Vec3T {
    T x{}, y{}, z{};

    T operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    T& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }

    friend bool operator==(const Vec3T&, const Vec3T&) = default;
    friend RT_FORMULA Vec3T operator-(Vec3T a) { return {-a.x, -a.y, -a.z}; }
    friend RT_FORMULA Vec3T operator+(Vec3T a, Vec3T b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend RT_FORMULA Vec3T operator-(Vec3T a, Vec3T b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    /// One by one, as colours are multiplied.
    friend RT_FORMULA Vec3T operator*(Vec3T a, Vec3T b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
    friend RT_FORMULA Vec3T operator*(Vec3T a, T s) { return {a.x * s, a.y * s, a.z * s}; }
    friend RT_FORMULA Vec3T operator*(T s, Vec3T a) { return a * s; }
    friend RT_FORMULA Vec3T operator/(Vec3T a, T s) { return {a.x / s, a.y / s, a.z / s}; }
    Vec3T& operator+=(Vec3T b) { return *this = *this + b; }
    Vec3T& operator*=(T s) { return *this = *this * s; }
};

template <typename T>
RT_FORMULA T dot(Vec3T<T> a, Vec3T<T> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <typename T>
RT_FORMULA Vec3T<T> cross(Vec3T<T> a, Vec3T<T> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Two unit vectors that complete the unit vector `n` to a right-handed basis (Duff et al. 2017, "Building an
/// Orthonormal Basis, Revisited").
template <typename T>
struct BasisT {
    Vec3T<T> tangent, bitangent;
};
template <typename T>
RT_FORMULA BasisT<T> basisAround(Vec3T<T> n) {
    const T one = 1;
    const T sign = copySign(one, n.z);
    const T a = -one / (sign + n.z);
    const T b = n.x * n.y * a;
    return {{one + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}
