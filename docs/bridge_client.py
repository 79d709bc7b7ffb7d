"""A whole client of RTBridge, by docs/bridge.md alone: flies forward for a while, stops, and saves the exact image.

  bridge_client.py LINK [--seconds S] [--output FILE.png] [--trust CERTIFICATE.pem]

LINK is the driver's, as RTBridge prints it. Needs the module websockets (Debian: python3-websockets), 10 or newer.
Ends with 0; 1: another page drives, or the link is a viewer's; 75: the bridge refuses or does not answer.
"""
import argparse
import asyncio
import json
import math
import ssl
import struct
import sys
import urllib.parse

import websockets

FRAME, STILL_PART = 1, 2
EXACT, LAST_PART = 2, 4
HEADER = struct.Struct("<BBHIQHHHHIIII")
PATIENCE = 30  # seconds that anything may take
LONG_PATIENCE = 3600  # but an image by paths


class Walker:
    """What one connection has seen so far."""

    def __init__(self, socket):
        self.socket = socket
        self.events = {}  # the newest of each name
        self.frames = 0
        self.parts = b""
        self.still = None  # PNG of the exact image, while that is what the server shows
        self.ended = False
        self.changed = asyncio.Event()
        self.sequence = 0

    async def listen(self):
        """Until the connection ends."""
        try:
            async for message in self.socket:
                if isinstance(message, str):
                    event = json.loads(message)
                    self.events[event["event"]] = event
                elif len(message) >= HEADER.size:
                    await self.take(message)
                self.changed.set()
        except websockets.ConnectionClosed:
            pass
        self.ended = True
        self.changed.set()

    async def take(self, message):
        kind, _, flags, stream, number, _, _, _, _, _, _, offset, total = HEADER.unpack_from(message)
        payload = message[HEADER.size:]
        if kind == FRAME:
            self.frames += 1
            self.still = None
        elif kind == STILL_PART:
            self.parts = payload if offset == 0 else self.parts + payload
            if flags & LAST_PART and len(self.parts) == total:
                self.still = self.parts if flags & EXACT else None
        if kind in (FRAME, STILL_PART):
            acknowledged = 1 if kind == FRAME else 4
            await self.socket.send(struct.pack("<BBHIQ", acknowledged, 0, 0, stream, number))

    async def until(self, holds, patience=PATIENCE):
        """Waits for it. Raises asyncio.TimeoutError, and ConnectionError with the bridge's reason."""
        async def wait():
            while not holds():
                if self.ended:
                    raise ConnectionError(self.socket.close_reason or "the connection ended")
                self.changed.clear()
                await self.changed.wait()
        await asyncio.wait_for(wait(), patience)

    async def hold(self, keys):
        """These keys are down from now on, for half a second unless it is said again."""
        self.sequence += 1
        head = struct.pack("<BBBBIii", 2, len(keys), 0, 0, self.sequence, 0, 0)
        await self.socket.send(head + keys.encode("ascii"))

    async def hold_for(self, keys, seconds):
        clock = asyncio.get_running_loop().time
        end = clock() + seconds
        while clock() < end:
            await self.hold(keys)
            await asyncio.sleep(min(0.2, max(0.0, end - clock())))
        await self.hold("")

    async def request(self, content):
        await self.socket.send(json.dumps(dict(content, id=1)))
        await self.until(lambda: "answer" in self.events)
        return self.events.pop("answer")

    async def at_rest(self):
        """The exact image, once nothing has changed for half a second."""
        while True:
            await self.until(lambda: self.still is not None)
            still = self.still
            await asyncio.sleep(0.5)
            if still is self.still:
                return still

    async def finished(self):
        """The exact image that nothing better follows: by paths, where the bridge has those made."""
        def holds():
            image = self.events.get("image", {"paths": False})
            return self.still is not None and image["paths"] and image["part"] == 1
        if self.events["welcome"]["rest"] == "paths":
            await self.until(holds, LONG_PATIENCE)
        return await self.at_rest()

    def eye(self):
        return self.events["status"]["eye"]


def distances(before, after, forward):
    """How far along `forward`, and how far beside it."""
    moved = [b - a for a, b in zip(before, after)]
    along = sum(m * f for m, f in zip(moved, forward))
    return along, math.sqrt(max(0.0, sum(m * m for m in moved) - along * along))


async def fly(walker, seconds):
    await walker.until(lambda: "status" in walker.events or "server" in walker.events)
    await walker.at_rest()
    if not (await walker.request({"do": "fly"}))["ok"]:
        sys.exit("bridge_client: the server does not fly")
    start, forward, frames = walker.eye(), walker.events["status"]["forward"], walker.frames
    await walker.hold_for("W", seconds)
    await walker.at_rest()
    stopped = walker.eye()
    await asyncio.sleep(1)
    along, beside = distances(start, stopped, forward)
    after = math.dist(stopped, walker.eye())
    print(f"along {along:.4f} beside {beside:.4f} after {after:.4f} frames {walker.frames - frames}")


async def run(options):
    page, _, token = options.link.partition("#t=")
    url = urllib.parse.urlsplit(page)
    secure = url.scheme == "https"
    trust = ssl.create_default_context(cafile=options.trust) if secure else None
    address = urllib.parse.urlunsplit(("wss" if secure else "ws", url.netloc, url.path + "ws", "", ""))
    async with websockets.connect(address, origin=f"{url.scheme}://{url.netloc}", subprotocols=["rtbridge.1"],
                                  compression=None, ssl=trust, max_size=None) as socket:
        walker = Walker(socket)
        await socket.send(json.dumps({"do": "hello", "v": 2, "token": token, "name": "bridge_client"}))
        listening = asyncio.ensure_future(walker.listen())
        await walker.until(lambda: "welcome" in walker.events)
        if walker.events["welcome"]["role"] != "driver":
            sys.exit("bridge_client: another page drives, or the link is a viewer's")
        await fly(walker, options.seconds)
        with open(options.output, "wb") as file:
            file.write(await walker.finished())
        listening.cancel()


def main():
    parser = argparse.ArgumentParser(description="Flies through a model that RTBridge shows, and saves what is seen then.")
    parser.add_argument("link")
    parser.add_argument("--seconds", type=float, default=1)
    parser.add_argument("--output", default="still.png")
    parser.add_argument("--trust", help="certificate of a bridge that signed its own")
    try:
        asyncio.run(run(parser.parse_args()))
    except (OSError, websockets.WebSocketException, asyncio.TimeoutError) as error:
        print(f"bridge_client: {str(error) or 'no answer'}", file=sys.stderr)
        return 75
    return 0


if __name__ == "__main__":
    sys.exit(main())
