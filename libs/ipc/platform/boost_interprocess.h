/// The only way to include Boost.Interprocess: every file must see the same settings.
#pragma once

// A lock that is not to be had within this time throws instead of hanging (the owner died; before Boost 1.78
// nothing else tells).
#define BOOST_INTERPROCESS_ENABLE_TIMEOUT_WHEN_LOCKING
#define BOOST_INTERPROCESS_TIMEOUT_WHEN_LOCKING_DURATION_MS 100
// To open what its maker never finished would take 300 s.
#define BOOST_INTERPROCESS_MANAGED_OPEN_OR_CREATE_INITIALIZE_TIMEOUT_SEC 1

#include <boost/interprocess/interprocess_fwd.hpp>
#include <boost/version.hpp>
