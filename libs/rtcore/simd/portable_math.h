/// Transcendental functions that give the same bits on every processor. The C library's choose their code by
/// the processor (fused multiply-add or not), so that two machines of one farm would render films that
/// differ. All are evaluated in double from sums, products and quotients alone, in a fixed order.
#pragma once

namespace rtcore {

/// log2(x) for finite x > 0 (denormals too); relative error below 2e-7. x <= 0 or NaN: -infinity.
float portableLog2(float x);
/// 2^x; underflows to 0 below -150, overflows to infinity above 128. Relative error below 1e-7. NaN: 0.
float portableExp2(float x);
/// e^x.
float portableExp(float x);
/// x^y for x >= 0; 0^0 = 1, 0^y = 0 for y > 0. Relative error below 1e-6 for |y log2 x| < 128. x < 0 counts
/// as 0.
float portablePow(float x, float y);
/// sin and cos of |x| <= 1000 radians; absolute error below 1e-7.
float portableSin(float x);
float portableCos(float x);
/// sin and cos of |degrees| <= 1e9, whole turns taken off before the angle becomes one in radians; absolute
/// error below 3e-10 and that of the angle itself.
double portableSinOfDegrees(double degrees);
double portableCosOfDegrees(double degrees);
/// The angle of (x, y) in (-pi, pi]; 0 for (0, 0) and for what is not finite. Absolute error below 2e-7.
float portableAtan2(float y, float x);
/// acos of x clamped to [-1, 1]. Absolute error below 3e-7.
float portableAcos(float x);

} // namespace rtcore
