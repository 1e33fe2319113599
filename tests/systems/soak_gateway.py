"""The gateway under bad clients and bad lines: no order lost or done twice, memory flat."""

import collections
import fcntl
import os
import pathlib
import pty
import random
import re
import select
import signal
import socket
import struct
import subprocess
import tempfile
import termios
import threading
import time
import unittest

from soak_support import PROGRAM, decoded, encoded

SIM = os.environ["SIM"]
LOAD = b"\x02  1%5d    1    3    0 0                              \x03"


class Sim:
    """A running gateway_sim on a free port."""

    def __init__(self, folder, *arguments):
        self.journal = pathlib.Path(folder) / "journal"
        # A program under AddressSanitizer keeps what it frees for a while; memory is measured here.
        asan = os.environ.get("ASAN_OPTIONS", "") + ":quarantine_size_mb=1:thread_local_quarantine_size_kb=64"
        self.child = subprocess.Popen([SIM, "--port", "0", "--journal", str(self.journal), *map(str, arguments)],
                                      stdout=subprocess.PIPE, text=True, env=dict(os.environ, ASAN_OPTIONS=asan))
        self.port = int(re.search(r"port (\d+)", self.child.stdout.readline()).group(1))

    def connect(self):
        return socket.create_connection(("127.0.0.1", self.port), 5)

    def memory(self):
        """Resident kilobytes."""
        return int(re.search(r"VmRSS:\s+(\d+)", pathlib.Path(f"/proc/{self.child.pid}/status").read_text()).group(1))

    def end(self):
        self.child.send_signal(signal.SIGINT)
        output, _ = self.child.communicate(timeout=30)
        return self.child.returncode, output

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.child.poll() is None:
            self.child.kill()
            self.child.communicate()

    def accepted(self):
        """How often each cargo was accepted."""
        lines = self.journal.read_text().splitlines() if self.journal.exists() else []
        return collections.Counter(line.split()[3] for line in lines if line.startswith("accepted") and len(line.split()) > 3)


def deliver(port, orders, *arguments, prefix="c", seconds=300):
    """A courier's status and summary; without a prefix it finds one of its own."""
    done = subprocess.run([PROGRAM, "--port", str(port), "--orders", str(orders), "--quiet", "--seconds", str(seconds),
                           *(["--prefix", prefix] if prefix else []), *map(str, arguments)], capture_output=True, text=True, timeout=seconds + 30)
    return done.returncode, done.stdout


def receive(connection, size, patience=5.0):
    """What has come when `size` bytes are there or the patience ends."""
    data = b""
    end = time.monotonic() + patience
    while len(data) < size and time.monotonic() < end:
        if select.select([connection], [], [], 0.1)[0]:
            piece = connection.recv(65536)
            if not piece:
                break
            data += piece
    return data


class BreakingLine(threading.Thread):
    """Stands between client and gateway, and cuts every connection after a while."""

    def __init__(self, target, seed):
        super().__init__(daemon=True)
        self.target, self.random, self.cuts, self.stopped = target, random.Random(seed), 0, False
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.listener.settimeout(0.1)
        self.port = self.listener.getsockname()[1]

    def run(self):
        while not self.stopped:
            try:
                client, _ = self.listener.accept()
            except TimeoutError:
                continue
            with client, socket.create_connection(("127.0.0.1", self.target), 5) as gateway:
                self.carry(client, gateway)
        self.listener.close()

    def carry(self, client, gateway):
        left = self.random.randrange(100, 12000)
        while left > 0 and not self.stopped:
            for source in select.select([client, gateway], [], [], 0.1)[0]:
                data = source.recv(min(left, 1 + self.random.randrange(300)))
                if not data:
                    return
                # Now and then the cut comes right with an order, before or behind it, so that its reply never arrives.
                cut = source is client and self.random.random() < 0.1
                if not cut or self.random.random() < 0.5:
                    (gateway if source is client else client).sendall(data)
                left = 0 if cut else left - len(data)
        self.cuts += 1


class Shell(unittest.TestCase):
    """The client on a terminal."""

    def until(self, terminal, wanted, patience=60):
        text = b""
        end = time.monotonic() + patience
        while wanted not in text and time.monotonic() < end:
            if select.select([terminal], [], [], 0.1)[0]:
                text += os.read(terminal, 65536)
        self.assertIn(wanted, text)
        return text

    def test_completes_orders_and_redraws_the_carts_in_place(self):
        with tempfile.TemporaryDirectory() as folder, Sim(folder, "--pace", 100, "--carts", 3, "--quiet") as sim:
            terminal, inner = pty.openpty()
            fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 40, 120, 0, 0))
            before = termios.tcgetattr(inner)
            client = subprocess.Popen([PROGRAM, "--port", str(sim.port)], stdin=inner, stdout=inner, start_new_session=True)
            first = self.until(terminal, b"    3  none")
            self.assertTrue(first.startswith(b"\x1b[2J"), first[:20])
            os.write(terminal, b"go_\t\t")  # two orders fit: they are listed
            self.until(terminal, b"go_parking  go_node")
            os.write(terminal, b"n\t")
            self.until(terminal, b"> go_node ")
            os.write(terminal, b"2 9\n")
            self.until(terminal, b"go_node 0 for cart 2 accepted: transit T000000001")
            self.until(terminal, b"    2  go_node")
            self.until(terminal, b"    2  transit_done")
            client.send_signal(signal.SIGINT)
            self.assertEqual(client.wait(60), 0)
            self.assertEqual(termios.tcgetattr(inner), before, "the terminal is not as it was")
            os.close(terminal)
            os.close(inner)

    def test_reads_orders_from_a_pipe(self):
        with tempfile.TemporaryDirectory() as folder, Sim(folder, "--quiet") as sim:
            done = subprocess.run([PROGRAM, "--port", str(sim.port)], input="load 1 3 2 box\nload 1 3 17\nlod\nidle_processing\n",
                                  capture_output=True, text=True, timeout=120)
            self.assertEqual(done.returncode, 0)
            self.assertIn("load 0 for cart 1 accepted: transit T000000001", done.stdout)
            self.assertIn("load 1 3 17: not sent: level: out_of_range", done.stdout)
            self.assertIn("lod: no such order", done.stdout)
            self.assertIn("idle_processing 1 for cart 0 accepted", done.stdout)
            self.assertEqual(sim.accepted(), {"box": 1})

    def test_obeys_more_orders_from_a_pipe_than_can_wait_for_replies_and_a_last_line_without_its_end(self):
        with tempfile.TemporaryDirectory() as folder, Sim(folder, "--carts", 64, "--quiet") as sim:
            lines = ["idle_processing"] * 200 + [f"load {1 + i} 3 0 box{i}" for i in range(64)]
            done = subprocess.run([PROGRAM, "--port", str(sim.port)], input="\n".join(lines), capture_output=True, text=True, timeout=120)
            self.assertEqual(done.returncode, 0)
            self.assertEqual(done.stdout.count(" accepted"), 264, done.stdout)
            self.assertEqual(sim.accepted(), {f"box{i}": 1 for i in range(64)})

    def test_sends_nothing_for_words_that_it_does_not_understand(self):
        with tempfile.TemporaryDirectory() as folder, Sim(folder, "--quiet") as sim:
            wrong = ["go_parking 1 x5", "go_node 2", "go_node 2 9 9", "load 1 3 2 box 4", "cancel_transits -1", "quit 1 a b"]
            done = subprocess.run([PROGRAM, "--port", str(sim.port)], input="\n".join(wrong), capture_output=True, text=True, timeout=120)
            self.assertEqual([line.split(": expected")[0] for line in done.stdout.splitlines()], wrong)
            self.assertIn("0 orders accepted, 0 refused", sim.end()[1])

    def test_listens_to_the_keyboard_while_the_gateway_is_away(self):
        terminal, inner = pty.openpty()
        before = termios.tcgetattr(inner)
        with tempfile.TemporaryDirectory() as folder, Sim(folder, "--quiet") as sim:
            client = subprocess.Popen([PROGRAM, "--port", str(sim.port)], stdin=inner, stdout=inner, start_new_session=True)
            self.until(terminal, b"\x1b[Hconnected")
            sim.end()
        self.until(terminal, b"\x1b[Hno connection")
        os.write(terminal, b"load 1 3\n")
        self.until(terminal, b"load 1 3: not sent: no connection")
        os.write(terminal, b"help\n")
        self.assertIn(b"load CART STATION", self.until(terminal, b"quit ").split(b"\x1b[H")[-1])
        os.write(terminal, b"quit\n")
        self.assertEqual(client.wait(60), 0)
        self.assertEqual(termios.tcgetattr(inner), before, "the terminal is not as it was")
        os.close(terminal)
        os.close(inner)

    def test_refuses_what_cannot_be_before_it_touches_the_terminal(self):
        wrong = [("--host", "localhost"), ("--port", "70000"), ("--orders", "1", "--carts", "0"), ("--orders", "1", "--carts", "4294967296"),
                 ("--orders", "1", "--prefix", "0123456789"), ("--orders", "1", "--prefix", "\t")]
        terminal, inner = pty.openpty()
        for arguments in wrong:
            with self.subTest(arguments=arguments):
                done = subprocess.run([PROGRAM, *arguments], stdin=inner, stdout=inner, stderr=subprocess.PIPE, text=True, timeout=60)
                self.assertEqual(done.returncode, 2)
                self.assertIn(arguments[-1].strip(), done.stderr)
                self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                self.assertEqual(select.select([terminal], [], [], 0)[0], [], "the terminal has got something")
        os.close(terminal)
        os.close(inner)

    def test_gives_up_when_its_captures_cannot_be_written(self):
        with tempfile.TemporaryDirectory() as folder, Sim(folder, "--quiet") as sim:
            (pathlib.Path(folder) / "sent.gateway").symlink_to("/dev/full")
            done = subprocess.run([PROGRAM, "--port", str(sim.port), "--orders", "4", "--quiet", "--record", folder],
                                  capture_output=True, text=True, timeout=120)
            self.assertEqual(done.returncode, 2)
            self.assertEqual(done.stderr.count("No space left on device"), 1, done.stderr)


class Gateway(unittest.TestCase):
    def test_every_order_is_delivered_exactly_once_over_connections_that_break(self):
        with tempfile.TemporaryDirectory() as folder, Sim(folder, "--pace", 20, "--carts", 6, "--crossing", 5, "--quiet") as sim:
            line = BreakingLine(sim.port, 7)
            line.start()
            status, output = deliver(line.port, 150, "--carts", 6, "--timeout", 20000)
            line.stopped = True
            line.join()
            self.assertEqual(status, 0, output)
            self.assertGreater(line.cuts, 5)
            self.assertRegex(output, r", [1-9]\d* of them in doubt")
            self.assertEqual(sim.accepted(), {f"c{i}": 1 for i in range(1, 151)})
            self.assertEqual(sim.end()[0], 0)

    def test_a_second_run_does_not_take_the_cargo_of_the_first_for_its_own(self):
        with tempfile.TemporaryDirectory() as folder, Sim(folder, "--pace", 20, "--quiet") as sim:
            for _ in range(2):
                line = BreakingLine(sim.port, 7)
                line.start()
                status, output = deliver(line.port, 40, "--timeout", 20000, prefix=None)
                line.stopped = True
                line.join()
                self.assertEqual(status, 0, output)
            accepted = sim.accepted()
            self.assertEqual((len(accepted), set(accepted.values())), (80, {1}))
            self.assertEqual({len(cargo) for cargo in accepted}, {6, 7})  # five characters and a number

    def test_what_is_left_of_a_broken_connection_tells_nothing_about_the_next(self):
        unused = {"use": "unused", "type": "none", "node": 0, "station_id": 0, "station_type": 0, "level": 0, "options": "", "transit_id": "",
                  "cargo_id": "", "phase": "none", "inputs": "", "outputs": "", "last_command": ""}

        def state(first, cross):
            return encoded("gateway", {"message": "cart_state", "fields": {
                "msg_id": 0, "cart_id": 1, "cart_status": ["ready"], "cart_phase": "none", "ini_node": 1, "rel_position": 0, "end_node": 2,
                "next_node": 3, "speed_mms": 0, "cross_confirmation_needed": cross, "orders": [first, unused]}})

        before = state(unused, 0)
        after = state({**unused, "use": "current", "type": "load", "cargo_id": "c1", "phase": "go_transit"}, 0)
        listener = socket.create_server(("127.0.0.1", 0))
        client = subprocess.Popen([PROGRAM, "--port", str(listener.getsockname()[1]), "--orders", "1", "--carts", "1", "--prefix", "c", "--quiet",
                                   "--seconds", "60"],
                                  stdout=subprocess.PIPE, text=True)
        for clean_up in (client.stdout.close, client.wait, client.kill):  # the last one first
            self.addCleanup(clean_up)
        with listener:
            with listener.accept()[0] as first:
                first.sendall(before)
                self.assertIn(b"c1", receive(first, 56))
                # The order is accepted, but its reply is lost with the connection. States from before it are under way: the client
                # answers the first one, which shows that the line is dead, and holds the second one.
                client.send_signal(signal.SIGSTOP)
                first.sendall(state(unused, 1) + before)
                first.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            client.send_signal(signal.SIGCONT)
            with listener.accept()[0] as second:
                self.assertEqual(receive(second, 1, 1.0), b"", "the order came twice")
                second.sendall(after)
                output, _ = client.communicate(timeout=60)
        self.assertEqual(client.returncode, 0, output)
        self.assertIn("1 of 1 orders delivered, 1 of them in doubt", output)

    def test_captures_hold_what_came_and_went(self):
        with tempfile.TemporaryDirectory() as folder, Sim(folder, "--pace", 20, "--record", folder, "--quiet") as sim:
            status, output = deliver(sim.port, 12)
            self.assertEqual(status, 0, output)
            sim.end()
            orders, errors = decoded("gateway", pathlib.Path(folder) / "to_gateway.gateway")
            self.assertEqual(errors, [])
            accepted = sum(o["message"] in ("load", "unload") for o in orders)
            states, errors = decoded("gateway", pathlib.Path(folder) / "to_client.gateway")
            self.assertEqual(errors, [])
            replies = [s["fields"]["src_msg_id"] for s in states if s["message"] in ("transit_ack", "nack")]
            self.assertEqual(len(replies), accepted)

    def test_clients_that_disappear_and_half_open_connections_cost_nothing(self):
        with tempfile.TemporaryDirectory() as folder, Sim(folder, "--pace", 20, "--quiet") as sim:
            for length in (0, 1, 30, 56):
                with sim.connect() as client:
                    client.sendall((LOAD % 5)[:length])
            silent = sim.connect()  # and never a word, as from a machine whose cable was pulled
            silent.sendall((LOAD % 6)[:20])
            status, output = deliver(sim.port, 8)
            self.assertEqual(status, 0, output)
            self.assertEqual(sim.accepted(), {f"c{i}": 1 for i in range(1, 9)})
            silent.settimeout(5)
            with silent:
                try:
                    while silent.recv(65536):
                        pass
                except ConnectionResetError:
                    pass  # the gateway hung up with our half order unread: as good an end as any

    def test_a_thousand_takeovers(self):
        with tempfile.TemporaryDirectory() as folder, Sim(folder, "--pace", 1000, "--quiet") as sim:
            with sim.connect() as first:
                receive(first, 400)
            before, held = sim.memory(), []
            for i in range(1000):
                held.append(sim.connect())
                held[-1].sendall((LOAD % (i % 100000))[: i % 57])
                if len(held) > 20:
                    held.pop(0).close()
            status, output = deliver(sim.port, 1)
            self.assertEqual(status, 0, output)
            self.assertLess(sim.memory(), before + 8192)
            for client in held:
                client.close()
            status, output = sim.end()
            self.assertEqual(status, 0)
            self.assertGreaterEqual(int(re.search(r"(\d+) connections", output).group(1)), 1002)

    def test_a_slow_reader_gets_replies_and_the_latest_states_and_costs_no_memory(self):
        with tempfile.TemporaryDirectory() as folder, Sim(folder, "--pace", 5, "--carts", 64, "--quiet") as sim:
            with sim.connect() as client:
                receive(client, 64 * 208)
                before = sim.memory()
                client.setblocking(False)
                sent = 0
                end = time.monotonic() + 3
                while time.monotonic() < end:  # orders without end, and never a look at the replies
                    try:
                        sent += client.send((LOAD % 1) * 50)
                    except BlockingIOError:
                        time.sleep(0.01)
                self.assertGreater(sent, 30000)  # how much more depends on the kernel's buffers
                self.assertLess(sim.memory(), before + 8192)
                client.setblocking(True)
                self.assertIn(b"\x02102", receive(client, 1 << 20))
            status, output = deliver(sim.port, 8)
            self.assertEqual(status, 0, output)

    def test_a_hundred_megabytes_of_garbage(self):
        with tempfile.TemporaryDirectory() as folder, Sim(folder, "--quiet") as sim:
            with sim.connect() as client:
                receive(client, 400)
                before = sim.memory()
                source = random.Random(3)
                block = source.randbytes(1 << 20) + bytes(source.choices(b"\x02\x03 0123456789A", k=1 << 18))
                for _ in range(80):  # 80 blocks of 1.25 MiB
                    client.sendall(block)
                self.assertLess(sim.memory(), before + 8192)
            with sim.connect() as client:  # a garbage record may look like an order, so only this one counts
                client.sendall(LOAD % 77)
                reply, heard, end = re.compile(rb"\x02(100|102).{5}    1  1   77"), b"", time.monotonic() + 60
                while not reply.search(heard) and time.monotonic() < end:
                    heard += receive(client, 1)
                self.assertRegex(heard, reply)
            status, output = sim.end()
            self.assertEqual(status, 0)
            skipped = int(re.search(r"(\d+) bytes skipped", output).group(1))
            self.assertGreater(skipped, 90_000_000)


if __name__ == "__main__":
    unittest.main()
