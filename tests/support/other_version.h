/// A server whose shared memory is laid out by another version of the suite.
#pragma once

#include "ipc/endpoint/link.h"
#include "ipc/layout/control_block.h"
#include "ipc/platform/owner_lock.h"
#include "support/ipc_instance.h"

#include <cstring>
#include <new>
#include <optional>

namespace test {

/// It lives as long as the object.
class ServerOfAnotherVersion {
  public:
    explicit ServerOfAnotherVersion(const IpcInstance& instance)
        : lock_(ipc::OwnerLock::tryTake(instance.names().serverLock(ipc::lockFolder()))),
          segment_(ipc::Segment::create(instance.names().control(), sizeof(ipc::ControlBlock))) {
        auto& block = *new (segment_.data()) ipc::ControlBlock;
        block.header.handshake = ipc::ownHandshake();
        ++block.header.handshake.protocolVersion;
        block.header.epoch = 5;
        std::strcpy(block.header.lockFolder, ipc::lockFolder().c_str());
        block.header.magic = ipc::kControlMagic;
    }

  private:
    std::optional<ipc::OwnerLock> lock_;
    ipc::Segment segment_;
};

} // namespace test
