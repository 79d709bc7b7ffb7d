// A whole client of RTServer: sends a command, holds a key down for a while, and saves the image as a PPM
// file. Needs the headers of libs/ipc and the library ipc_endpoint; no ray tracer source.
//   example_client [instance]
#include "ipc/endpoint/client.h"

#include <chrono>
#include <cstdio>
#include <exception>
#include <string>
#include <thread>

using namespace std::chrono_literals;

// Pixels are RGBA, 8 bits each, from the top left. False: the file could not be written.
static bool save(const ipc::Frame& frame, const char* path) {
    std::FILE* file = std::fopen(path, "wb");
    if (file == nullptr) return false;
    std::fprintf(file, "P6\n%u %u\n255\n", frame.info.width, frame.info.height);
    for (std::size_t i = 0; i < frame.pixels.size(); i += 4) std::fwrite(&frame.pixels[i], 1, 3, file);
    return std::fclose(file) == 0;
}

static int run(const std::string& instance) {
    ipc::Client client(instance); // waits up to two seconds for the server

    // A command is a line of text; so is the answer.
    const ipc::Reply reply = client.request("ping");
    if (reply.status != ipc::ReplyStatus::Done) {
        std::fprintf(stderr, "example_client: ping: %s\n", reply.text.c_str());
        return 1;
    }
    std::printf("ping: %s\n", reply.text.c_str());

    // Keys are numbers; 'W' moves forward while it is down. They are released when the client ends or dies.
    client.pressKey('W');
    std::this_thread::sleep_for(100ms);
    client.releaseKey('W');

    ipc::Frame frame;
    if (!client.waitForFrame(frame, 5s)) {
        std::fprintf(stderr, "example_client: no frame within 5 seconds\n");
        return 1;
    }
    const ipc::Status status = client.status();
    std::printf("frame %llu: %u x %u, %.1f frames/s, %llu polygons\n",
                static_cast<unsigned long long>(frame.info.number), frame.info.width, frame.info.height,
                status.framesPerSecond, static_cast<unsigned long long>(status.polygons));
    return save(frame, "frame.ppm") ? 0 : 73;
}

int main(int count, char** words) {
    try {
        return run(count > 1 ? words[1] : "default");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "example_client: %s\n", error.what());
        return 75;
    }
}
