#pragma once

#include "frame.h"

namespace lds::ui {

inline ports::Frame frame(ports::FrameMeaning meaning, const QStringList& arguments = {},
                          ports::Direction direction = ports::Direction::Sent)
{
    ports::Frame result;
    result.wallMs = 1'700'000'000'000;
    result.direction = direction;
    result.meaning = meaning;
    result.arguments = arguments;
    result.bytes = QByteArray::fromHex("000100000006010300640047");
    result.reconstructedPrefix = direction == ports::Direction::Sent ? 7 : 0;
    result.protocol = QStringLiteral("Modbus TCP");
    result.peer = QStringLiteral("modbus-tcp://127.0.0.1:502");
    return result;
}

inline ports::Frame read(int first, int last)
{
    return frame(ports::FrameMeaning::Read, {QString::number(first), QString::number(last)});
}
inline ports::Frame poll() { return read(400011, 400022); }
inline ports::Frame pollAnswer()
{
    return frame(ports::FrameMeaning::Answer,
                 {QStringLiteral("400011"), QStringLiteral("400022"), QStringLiteral("measuredValue=12345")},
                 ports::Direction::Received);
}
inline ports::Frame refused()
{
    return frame(ports::FrameMeaning::Refused, {QStringLiteral("0x10"), QStringLiteral("0x03")},
                 ports::Direction::Received);
}

} // namespace lds::ui
