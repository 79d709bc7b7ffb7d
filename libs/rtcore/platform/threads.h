/// Threads of OpenMP, or the only one there is without it.
#pragma once

namespace rtcore {

/// How many work: `wanted`, or for 0 what OpenMP thinks best; 1 without OpenMP.
int threadsFor(int wanted);

/// The number of the calling thread in its parallel region, from 0.
int threadNumber();

} // namespace rtcore
