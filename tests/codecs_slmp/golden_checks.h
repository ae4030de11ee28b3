#pragma once

#include "golden_frames.h"
#include "slmp_response_frame.h"
#include "slmp_server_request.h"

#include <QTest>

namespace golden {

inline QByteArray hex(const char* text) { return QByteArray::fromHex(text); }

inline const char* nameOf(FrameType type)
{
    switch (type) {
    case FrameType::St:
        return "ST";
    case FrameType::Mt:
        return "MT";
    case FrameType::Lmt:
        return "LMT";
    }
    return "?";
}

/// The request frame that the golden frames put around a message.
inline lds::slmp::RequestFrame around(FrameType type, const lds::slmp::Message& message,
                                      const lds::slmp::Route& route = lds::slmp::localStation)
{
    lds::slmp::RequestFrame frame;
    frame.type = type;
    frame.serial = type == FrameType::St ? 0 : 0x1234;
    frame.route = route;
    frame.timer = 16;
    frame.message = message;
    return frame;
}

/// Network 0, node 255 and the MAC address that the golden IP Address Set names.
inline const lds::slmp::Station sensor{0, 255, {{0x00, 0xf8, 0xa0, 0x01, 0x02, 0x03}}};

/// A row "name TYPE" for every golden frame of one of these names, column "frame" its index.
inline void addRows(std::initializer_list<const char*> names)
{
    QTest::addColumn<int>("frame");
    for (int i = 0; i < int(std::size(frames)); ++i) {
        for (const char* name : names) {
            if (qstrcmp(frames[i].name, name) == 0)
                QTest::addRow("%s %s", name, nameOf(frames[i].type)) << i;
        }
    }
}

inline const Frame& fetched()
{
    QFETCH(int, frame);
    return frames[frame];
}

/// Client and server agree with the golden bytes: the client's request, what the server reads in it, the
/// server's response with `answer` as its data, and the data that the client finds in it.
template <typename Request>
void checkBothDirections(const Frame& frame, const Request& request, const QByteArray& answer,
                         const lds::slmp::Route& route = lds::slmp::localStation)
{
    using namespace lds::slmp;
    const RequestFrame sent = around(frame.type, encodeRequest(request), route);
    QCOMPARE(encodeRequestFrame(sent).toHex(' '), hex(frame.request).toHex(' '));

    const Station station{route.network, route.node, sensor.mac};
    const auto accepted = decodeServerRequest(hex(frame.request), station);
    QVERIFY(accepted.has_value());
    QVERIFY(accepted->frame == sent);
    QVERIFY(std::holds_alternative<Request>(accepted->request));
    QVERIFY(std::get<Request>(accepted->request) == request);

    QCOMPARE(encodeAnswer(accepted->frame, answer).toHex(' '), hex(frame.response).toHex(' '));
    const auto data = decodeAnswer(sent, hex(frame.response));
    QVERIFY(data.has_value());
    QCOMPARE(*data, answer);
}

/// What a server answers to this message in an MT frame: -1 when it accepts it, -2 when it stays silent,
/// else the complete code.
inline int judged(const lds::slmp::Message& message, FrameType type = FrameType::Mt)
{
    using namespace lds::slmp;
    const auto accepted = decodeServerRequest(encodeRequestFrame(around(type, message)), sensor);
    if (accepted)
        return -1;
    return accepted.error().answer ? int(*accepted.error().answer) : -2;
}

inline constexpr int accepts = -1;
inline constexpr int silent = -2;

} // namespace golden
