#!/usr/bin/python3
"""Drops a file onto a window as a file manager does, by the protocol XDND 5.

    drop_file.py DISPLAY WINDOW FILE

Exit code 0 once the window has taken the file; otherwise a sentence and 1.
"""
import select
import sys
import time
from urllib.parse import quote

from Xlib import X, display
from Xlib.protocol import event

PATIENCE = 20  # seconds


class Drag:
    def __init__(self, name, window, file):
        self.display = display.Display(name)
        self.root = self.display.screen().root
        self.target = self.display.create_resource_object("window", window)
        self.source = self.root.create_window(0, 0, 1, 1, 0, self.display.screen().root_depth)
        self.source.set_selection_owner(self.atom("XdndSelection"), X.CurrentTime)
        self.text = ("file://" + quote(file) + "\r\n").encode()

    def atom(self, name):
        return self.display.intern_atom(name)

    def send(self, kind, *data):
        longs = [self.source.id, *data] + [0] * (4 - len(data))
        self.target.send_event(event.ClientMessage(window=self.target, client_type=self.atom(kind), data=(32, longs)))
        self.display.flush()

    def hand_over(self, request):
        request.requestor.change_property(request.property, request.target, 8, self.text)
        request.requestor.send_event(
            event.SelectionNotify(time=request.time, requestor=request.requestor, selection=request.selection,
                                  target=request.target, property=request.property))
        self.display.flush()

    def answer(self, kind):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            while self.display.pending_events():
                one = self.display.next_event()
                if one.type == X.SelectionRequest:
                    self.hand_over(one)
                elif one.type == X.ClientMessage and one.client_type == self.atom(kind):
                    return one.data[1]
            select.select([self.display], [], [], 0.1)
        sys.exit("the window does not answer with " + kind)

    def drop(self):
        size = self.target.get_geometry()
        corner = self.root.translate_coords(self.target, 0, 0)
        x, y = corner.x + size.width // 2, corner.y + size.height // 2
        self.send("XdndEnter", 5 << 24, self.atom("text/uri-list"))
        self.send("XdndPosition", 0, x << 16 | y, X.CurrentTime, self.atom("XdndActionCopy"))
        if not self.answer("XdndStatus")[1] & 1:
            sys.exit("the window refuses files")
        self.send("XdndDrop", 0, X.CurrentTime)
        self.answer("XdndFinished")


if __name__ == "__main__":
    Drag(sys.argv[1], int(sys.argv[2]), sys.argv[3]).drop()
