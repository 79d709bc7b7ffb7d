/// A server whose shared memory is laid out by another version of the suite.
#pragma once

#include "ipc/endpoint/link.h"
#include "ipc/layout/control_block.h"
#include "support/ipc_instance.h"

#include <new>

namespace test {

/// It lives as long as the object.
class ServerOfAnotherVersion {
  public:
    explicit ServerOfAnotherVersion(const IpcInstance& instance)
        : segment_(ipc::Segment::create(instance.names().control(), sizeof(ipc::ControlBlock))) {
        segment_.tryLock(ipc::kServerLock);
        auto& block = *new (segment_.data()) ipc::ControlBlock;
        block.header.handshake = ipc::ownHandshake();
        ++block.header.handshake.protocolVersion;
        block.header.epoch = 5;
        block.header.magic = ipc::kControlMagic;
    }

  private:
    ipc::Segment segment_;
};

} // namespace test
