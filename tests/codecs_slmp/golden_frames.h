#pragma once

#include "slmp_frame.h"

/// Every command of §5.4.3 in every type its table allows, requests and their responses, written byte by
/// byte from the tables and not by the codec; fields apart by spaces. In all of them: serial number 1234H
/// (MT, LMT), timer 16 x 250 ms, local station (network 0, node 255, processor 03FFH) unless said.
///
/// ST   subheader 2, network 1, node 1, processor 2, reserved 1, length 2, then timer 2, command 2,
///      subcommand 2 in a request and complete code 2 in a response, then data
/// MT   the same with serial number 2 and reserved 2 after the subheader
/// LMT  as MT, with processor sub-number 1, reserved 1 and extended station 2 in place of the reserved byte;
///      after the subcommand, which responses have too, reserved 1, data id 1, divisions 2, division no. 2
namespace golden {

using lds::slmp::FrameType;

struct Frame {
    const char* name;
    FrameType type;
    const char* request;
    const char* response;
};

// clang-format off
inline constexpr Frame frames[] = {
    // Read, words: D100 and D101
    {"read-words", FrameType::St,
     "5000 00 ff ff03 00 0c00 1000 0104 0000 640000 a8 0200",
     "d000 00 ff ff03 00 0600 0000 50c3 0000"},
    {"read-words", FrameType::Mt,
     "5400 3412 0000 00 ff ff03 00 0c00 1000 0104 0000 640000 a8 0200",
     "d400 3412 0000 00 ff ff03 00 0600 0000 50c3 0000"},
    {"read-words", FrameType::Lmt,
     "6800 3412 0000 00 ff ff03 00 00 0000 1200 1000 0104 0000 00 00 0000 0000 640000 a8 0200",
     "e800 3412 0000 00 ff ff03 00 00 0000 1000 0000 0104 0000 00 00 0000 0000 50c3 0000"},
    // Read, bits: Y0 to YA
    {"read-bits", FrameType::St,
     "5000 00 ff ff03 00 0c00 1000 0104 0100 000000 9d 0b00",
     "d000 00 ff ff03 00 0800 0000 00 01 00 10 00 10"},
    {"read-bits", FrameType::Mt,
     "5400 3412 0000 00 ff ff03 00 0c00 1000 0104 0100 000000 9d 0b00",
     "d400 3412 0000 00 ff ff03 00 0800 0000 00 01 00 10 00 10"},
    {"read-bits", FrameType::Lmt,
     "6800 3412 0000 00 ff ff03 00 00 0000 1200 1000 0104 0100 00 00 0000 0000 000000 9d 0b00",
     "e800 3412 0000 00 ff ff03 00 00 0000 1200 0000 0104 0100 00 00 0000 0000 00 01 00 10 00 10"},
    // Read Random: words D10 and D21, double words D19 and D100
    {"read-random", FrameType::St,
     "5000 00 ff ff03 00 1800 1000 0304 0000 02 02 0a0000 a8 150000 a8 130000 a8 640000 a8",
     "d000 00 ff ff03 00 0e00 0000 0804 0002 c7cfffff 50c30000"},
    {"read-random", FrameType::Mt,
     "5400 3412 0000 00 ff ff03 00 1800 1000 0304 0000 02 02 0a0000 a8 150000 a8 130000 a8 640000 a8",
     "d400 3412 0000 00 ff ff03 00 0e00 0000 0804 0002 c7cfffff 50c30000"},
    {"read-random", FrameType::Lmt,
     "6800 3412 0000 00 ff ff03 00 00 0000 1e00 1000 0304 0000 00 00 0000 0000 02 02 0a0000 a8 150000 a8 130000 a8 640000 a8",
     "e800 3412 0000 00 ff ff03 00 00 0000 1800 0000 0304 0000 00 00 0000 0000 0804 0002 c7cfffff 50c30000"},
    // Write, words: D102 and D103
    {"write-words", FrameType::St,
     "5000 00 ff ff03 00 1000 1000 0114 0000 660000 a8 0200 b03c ffff",
     "d000 00 ff ff03 00 0200 0000"},
    {"write-words", FrameType::Mt,
     "5400 3412 0000 00 ff ff03 00 1000 1000 0114 0000 660000 a8 0200 b03c ffff",
     "d400 3412 0000 00 ff ff03 00 0200 0000"},
    {"write-words", FrameType::Lmt,
     "6800 3412 0000 00 ff ff03 00 00 0000 1600 1000 0114 0000 00 00 0000 0000 660000 a8 0200 b03c ffff",
     "e800 3412 0000 00 ff ff03 00 00 0000 0c00 0000 0114 0000 00 00 0000 0000"},
    // Write, bits: Y0 to Y2
    {"write-bits", FrameType::St,
     "5000 00 ff ff03 00 0e00 1000 0114 0100 000000 9d 0300 10 10",
     "d000 00 ff ff03 00 0200 0000"},
    {"write-bits", FrameType::Mt,
     "5400 3412 0000 00 ff ff03 00 0e00 1000 0114 0100 000000 9d 0300 10 10",
     "d400 3412 0000 00 ff ff03 00 0200 0000"},
    {"write-bits", FrameType::Lmt,
     "6800 3412 0000 00 ff ff03 00 00 0000 1400 1000 0114 0100 00 00 0000 0000 000000 9d 0300 10 10",
     "e800 3412 0000 00 ff ff03 00 00 0000 0c00 0000 0114 0100 00 00 0000 0000"},
    // Write Random: word D51, double words D100 and D102
    {"write-random", FrameType::St,
     "5000 00 ff ff03 00 1e00 1000 0214 0000 01 02 330000 a8 0100 640000 a8 50c30000 660000 a8 b03cffff",
     "d000 00 ff ff03 00 0200 0000"},
    {"write-random", FrameType::Mt,
     "5400 3412 0000 00 ff ff03 00 1e00 1000 0214 0000 01 02 330000 a8 0100 640000 a8 50c30000 660000 a8 b03cffff",
     "d400 3412 0000 00 ff ff03 00 0200 0000"},
    {"write-random", FrameType::Lmt,
     "6800 3412 0000 00 ff ff03 00 00 0000 2400 1000 0214 0000 00 00 0000 0000 01 02 330000 a8 0100 640000 a8 50c30000 660000 a8 b03cffff",
     "e800 3412 0000 00 ff ff03 00 00 0000 0c00 0000 0214 0000 00 00 0000 0000"},
    // Write Random, bits: Y0 on, Y10 off
    {"write-random-bits", FrameType::St,
     "5000 00 ff ff03 00 1100 1000 0214 0100 02 000000 9d 01 100000 9d 00",
     "d000 00 ff ff03 00 0200 0000"},
    {"write-random-bits", FrameType::Mt,
     "5400 3412 0000 00 ff ff03 00 1100 1000 0214 0100 02 000000 9d 01 100000 9d 00",
     "d400 3412 0000 00 ff ff03 00 0200 0000"},
    {"write-random-bits", FrameType::Lmt,
     "6800 3412 0000 00 ff ff03 00 00 0000 1700 1000 0214 0100 00 00 0000 0000 02 000000 9d 01 100000 9d 00",
     "e800 3412 0000 00 ff ff03 00 00 0000 0c00 0000 0214 0100 00 00 0000 0000"},
    // Remote Run, forced, nothing cleared
    {"remote-run", FrameType::St,
     "5000 00 ff ff03 00 0a00 1000 0110 0000 0300 00 00",
     "d000 00 ff ff03 00 0200 0000"},
    {"remote-run", FrameType::Mt,
     "5400 3412 0000 00 ff ff03 00 0a00 1000 0110 0000 0300 00 00",
     "d400 3412 0000 00 ff ff03 00 0200 0000"},
    {"remote-run", FrameType::Lmt,
     "6800 3412 0000 00 ff ff03 00 00 0000 1000 1000 0110 0000 00 00 0000 0000 0300 00 00",
     "e800 3412 0000 00 ff ff03 00 00 0000 0c00 0000 0110 0000 00 00 0000 0000"},
    // Remote Stop
    {"remote-stop", FrameType::St,
     "5000 00 ff ff03 00 0800 1000 0210 0000 0100",
     "d000 00 ff ff03 00 0200 0000"},
    {"remote-stop", FrameType::Mt,
     "5400 3412 0000 00 ff ff03 00 0800 1000 0210 0000 0100",
     "d400 3412 0000 00 ff ff03 00 0200 0000"},
    {"remote-stop", FrameType::Lmt,
     "6800 3412 0000 00 ff ff03 00 00 0000 0e00 1000 0210 0000 00 00 0000 0000 0100",
     "e800 3412 0000 00 ff ff03 00 00 0000 0c00 0000 0210 0000 00 00 0000 0000"},
    // Read Type Name
    {"read-type-name", FrameType::St,
     "5000 00 ff ff03 00 0600 1000 0101 0000",
     "d000 00 ff ff03 00 1400 0000 484c2d47323033422d532d4d4b202020 0901"},
    {"read-type-name", FrameType::Mt,
     "5400 3412 0000 00 ff ff03 00 0600 1000 0101 0000",
     "d400 3412 0000 00 ff ff03 00 1400 0000 484c2d47323033422d532d4d4b202020 0901"},
    {"read-type-name", FrameType::Lmt,
     "6800 3412 0000 00 ff ff03 00 00 0000 0c00 1000 0101 0000 00 00 0000 0000",
     "e800 3412 0000 00 ff ff03 00 00 0000 1e00 0000 0101 0000 00 00 0000 0000 484c2d47323033422d532d4d4b202020 0901"},
    // Self Test with "ABCDE"
    {"self-test", FrameType::St,
     "5000 00 ff ff03 00 0d00 1000 1906 0000 0500 4142434445",
     "d000 00 ff ff03 00 0900 0000 0500 4142434445"},
    {"self-test", FrameType::Mt,
     "5400 3412 0000 00 ff ff03 00 0d00 1000 1906 0000 0500 4142434445",
     "d400 3412 0000 00 ff ff03 00 0900 0000 0500 4142434445"},
    {"self-test", FrameType::Lmt,
     "6800 3412 0000 00 ff ff03 00 00 0000 1300 1000 1906 0000 00 00 0000 0000 0500 4142434445",
     "e800 3412 0000 00 ff ff03 00 00 0000 1300 0000 1906 0000 00 00 0000 0000 0500 4142434445"},
    // Node Search: client 01-02-03-04-05-06 at 192.168.1.10, sensor 00-F8-A0-01-02-03 at 192.168.1.6
    {"node-search", FrameType::Mt,
     "5400 3412 0000 00 ff ff03 00 1100 1000 300e 0000 060504030201 04 0a01a8c0",
     "d400 3412 0000 00 ff ff03 00 3900 0000 060504030201 04 0a01a8c0 030201a0f800 04 0601a8c0 00ffffff 0101a8c0 04 6c696e65 0901 08000002 0201 04 ffffffff ffff 0000 b5b0 01"},
    // IP Address Set: 192.168.1.20, 255.255.255.0, 192.168.1.1, host name "line"
    {"ip-address-set", FrameType::Mt,
     "5400 3412 0000 00 ff ff03 00 3100 1000 310e 0000 060504030201 04 0a01a8c0 030201a0f800 04 1401a8c0 00ffffff 0101a8c0 04 6c696e65 04 ffffffff ffff 01",
     "d400 3412 0000 00 ff ff03 00 0800 0000 060504030201"},
    {"ip-address-set", FrameType::Lmt,
     "6800 3412 0000 00 ff ff03 00 00 0000 3700 1000 310e 0000 00 00 0000 0000 060504030201 04 0a01a8c0 030201a0f800 04 1401a8c0 00ffffff 0101a8c0 04 6c696e65 04 ffffffff ffff 01",
     "e800 3412 0000 00 ff ff03 00 00 0000 1200 0000 310e 0000 00 00 0000 0000 060504030201"},
    // Device Info Compare: all three, the sensor is newer
    {"device-info-compare", FrameType::Mt,
     "5400 3412 0000 00 ff ff03 00 1000 1000 320e 0000 0700 0901 08000002 0001",
     "d400 3412 0000 00 ff ff03 00 0600 0000 0700 0440"},
    // Write as cyclic writing sends it, to network 2, node 5: D1000 to D1004
    {"cyclic-write", FrameType::Mt,
     "5400 3412 0000 02 05 ff03 00 1600 1000 0114 0000 e80300 a8 0500 c7cf ffff 1027 0804 0100",
     "d400 3412 0000 02 05 ff03 00 0200 0000"},
};

/// The refusal of "read-words" with C05CH. ST and MT carry error information: network 1, node 1,
/// processor 2, reserved 1, command 2, subcommand 2.
struct Refusal {
    FrameType type;
    const char* response;
};

inline constexpr Refusal refusals[] = {
    {FrameType::St, "d000 00 ff ff03 00 0b00 5cc0 00 ff ff03 00 0104 0000"},
    {FrameType::Mt, "d400 3412 0000 00 ff ff03 00 0b00 5cc0 00 ff ff03 00 0104 0000"},
    {FrameType::Lmt, "e800 3412 0000 00 ff ff03 00 00 0000 0c00 5cc0 0104 0000 00 00 0000 0000"},
};
// clang-format on

} // namespace golden
