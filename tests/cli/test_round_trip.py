"""decode | encode gives back clean input byte for byte, and says what it cannot give back."""

import unittest

from goldens import CAN, DAISY, GATEWAY, can_text, daisy_packet, gateway_record
from tool import ToolCase, can_log, octets, packet, record, trama


class RoundTrip(ToolCase):
    def there_and_back(self, protocol, given, *options, encode=(), status=0):
        decoded = trama("decode", protocol, *options, given=given)
        self.assertEqual(decoded.status, status, decoded.out[-300:])
        encoded = trama("encode", protocol, *options, *encode, given=decoded.out)
        return encoded

    def test_every_message(self):
        for protocol, packets in (("daisy", [daisy_packet(g) for g in DAISY]), ("gateway", [gateway_record(g) for g in GATEWAY]),
                                  ("can", [can_text(g) for g in CAN])):
            for each in packets + [b"".join(packets), b"".join(reversed(packets)) * 3]:
                self.assertEqual(self.there_and_back(protocol, each), (0, each, ""))

    def test_hex(self):
        for protocol, packets in (("daisy", map(daisy_packet, DAISY)), ("gateway", map(gateway_record, GATEWAY))):
            text = "".join(each.hex(" ") + "\n" for each in packets).encode()
            self.assertEqual(self.there_and_back(protocol, text, "--hex"), (0, text, ""))

    def test_every_byte_of_a_description(self):
        given = packet("00 10 81", bytes(range(0, 251))) + packet("00 10 81", bytes(range(5, 256)))
        decoded = trama("decode", "daisy", given=packet("00 10 81", b"plain") * 16 + given)
        self.assertEqual(decoded.status, 0, decoded.out)
        encoded = trama("encode", "daisy", given=decoded.out)
        self.assertEqual(encoded, (0, packet("00 10 81", b"plain") * 16 + given, ""))

    def test_every_printable_character_of_a_text(self):
        characters = "".join(map(chr, range(0x20, 0x7F)))
        given = b"".join(record("102" + "    1" * 2 + "  1" + "    1" + f"{characters[i:i + 50]:<80}") for i in range(0, 95))
        self.assertEqual(self.there_and_back("gateway", given), (0, given, ""))

    def test_integers_of_every_size(self):
        given = b"".join(packet("10 00 42", (1 << bit).to_bytes(4, "little") ) for bit in range(32))
        given += b"".join(packet("10 00 42", ((1 << 32) - (1 << bit)).to_bytes(4, "little")) for bit in range(32))
        self.assertEqual(self.there_and_back("daisy", given), (0, given, ""))

    def test_what_was_justified_otherwise_comes_back_canonical(self):
        self.assertEqual(self.there_and_back("gateway", record("20 7    003  ")), (0, record(" 20    7    3"), ""))

    def test_violations_need_unchecked(self):
        for protocol, given in (("daisy", packet("10 1f 40", b"\7")), ("can", can_log("081#02C952")),
                                ("gateway", record("101    1    2  4    3")),
                                ("daisy", packet("00 30 c4", octets("c1 01 04 02 03 ff ff")))):
            refused = self.there_and_back(protocol, given, status=1)
            self.assertEqual((refused.status, refused.out), (1, b""))
            self.assertEqual(self.there_and_back(protocol, given, encode=["--unchecked"], status=1), (0, given, ""))

    def test_errors_are_left_out(self):
        good = record(" 50   12")
        encoded = self.there_and_back("gateway", good + b"noise" + good + record("999") + good, status=1)
        self.assertEqual((encoded.status, encoded.out), (1, good * 3))
        self.assertIn("2", encoded.err)
        self.assertIn("4", encoded.err)


if __name__ == "__main__":
    unittest.main()
