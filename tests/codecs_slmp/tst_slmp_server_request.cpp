#include "golden_checks.h"

#include <QTest>

using namespace lds::slmp;
using golden::hex;

namespace {

const QList<FrameType> allTypes{FrameType::St, FrameType::Mt, FrameType::Lmt};

Message goldenMessage(const char* name)
{
    for (const golden::Frame& frame : golden::frames) {
        if (qstrcmp(frame.name, name) == 0)
            return decodeRequestFrame(hex(frame.request))->message;
    }
    return {};
}

bool isAccepted(const Station& station, FrameType type, const Route& route)
{
    const Message read = goldenMessage("read-words");
    const auto accepted = decodeServerRequest(encodeRequestFrame(golden::around(type, read, route)), station);
    return accepted || accepted.error().answer != CompleteCode::Request;
}

} // namespace

class SlmpServerRequestTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void eachTypeSupportsTheCommandsOfItsColumn_data();
    void eachTypeSupportsTheCommandsOfItsColumn();
    void otherCommandsGetC059_data();
    void otherCommandsGetC059();
    void stationsAreTheCombinationsOfTheTable();
    void theLocalStationIsAlwaysAccepted();
    void anotherStationIsAcceptedByItsOwnNumbers();
    void lmtReachesTheLocalStationOnly();
    void refusalsKeepTheOrderOfTheirHeader();
};

// §5.4.3, "Server function supported command list" with its notes 2 (no response) and 3 (C05CH).
void SlmpServerRequestTest::eachTypeSupportsTheCommandsOfItsColumn_data()
{
    QTest::addColumn<Message>("message");
    QTest::addColumn<QList<int>>("judgments"); // ST, MT, LMT
    const int yes = golden::accepts;
    const int c05c = int(CompleteCode::Request);
    for (const char* name : {"read-words", "write-words", "write-random", "read-random", "remote-run",
                             "remote-stop", "read-type-name", "self-test"})
        QTest::newRow(name) << goldenMessage(name) << QList<int>{yes, yes, yes};
    QTest::newRow("node-search") << goldenMessage("node-search")
                                 << QList<int>{golden::silent, yes, golden::silent};
    QTest::newRow("ip-address-set") << goldenMessage("ip-address-set") << QList<int>{c05c, yes, yes};
    QTest::newRow("device-info-compare")
        << goldenMessage("device-info-compare") << QList<int>{c05c, yes, c05c};
}

void SlmpServerRequestTest::eachTypeSupportsTheCommandsOfItsColumn()
{
    QFETCH(Message, message);
    QFETCH(QList<int>, judgments);
    for (const FrameType type : allTypes)
        QCOMPARE(golden::judged(message, type), judgments.at(int(type)));
}

void SlmpServerRequestTest::otherCommandsGetC059_data()
{
    QTest::addColumn<int>("command");
    for (const int command : {0x0000, 0x0406, 0x0613, 0x0801, 0x0e33, 0x1003, 0x1005, 0x1006, 0x1406, 0x1617,
                              0x1631, 0x0402, 0x0104, 0xffff})
        QTest::addRow("%04XH", command) << command;
}

void SlmpServerRequestTest::otherCommandsGetC059()
{
    QFETCH(int, command);
    for (const FrameType type : allTypes)
        QCOMPARE(golden::judged({Command(command), 0, hex("0100")}, type), int(CompleteCode::Command));
}

// §5.4.2, "Combination of network numbers and station numbers".
void SlmpServerRequestTest::stationsAreTheCombinationsOfTheTable()
{
    for (int node = 0; node < 256; ++node) {
        const bool other = (node >= 1 && node <= 120) || node == 125 || node == 126;
        QCOMPARE(isStation(0, quint8(node)), node == 255);
        QCOMPARE(isStation(1, quint8(node)), other);
        QCOMPARE(isStation(239, quint8(node)), other);
        QVERIFY(!isStation(240, quint8(node)));
        QVERIFY(!isStation(255, quint8(node)));
    }
}

// §5.4.2 notes: network 0, node 255, processor 03FFH.
void SlmpServerRequestTest::theLocalStationIsAlwaysAccepted()
{
    for (const FrameType type : allTypes) {
        QVERIFY(isAccepted({0, 255, {}}, type, {0, 255, 0x03ff}));
        QVERIFY(isAccepted({7, 3, {}}, type, {0, 255, 0x03ff}));
        QVERIFY(!isAccepted({0, 255, {}}, type, {0, 255, 0x03e0}));
        QVERIFY(!isAccepted({0, 255, {}}, type, {0, 1, 0x03ff}));
        QVERIFY(!isAccepted({0, 255, {}}, type, {1, 255, 0x03ff}));
    }
}

void SlmpServerRequestTest::anotherStationIsAcceptedByItsOwnNumbers()
{
    for (const FrameType type : {FrameType::St, FrameType::Mt}) {
        QVERIFY(isAccepted({7, 3, {}}, type, {7, 3, 0x03ff}));
        QVERIFY(!isAccepted({7, 3, {}}, type, {7, 4, 0x03ff}));
        QVERIFY(!isAccepted({7, 3, {}}, type, {6, 3, 0x03ff}));
        QVERIFY(!isAccepted({7, 3, {}}, type, {7, 3, 0x03d0}));
    }
}

// §5.4.2: "LMT type SLMP messages are not supported (only used by the local station)".
void SlmpServerRequestTest::lmtReachesTheLocalStationOnly()
{
    QVERIFY(!isAccepted({7, 3, {}}, FrameType::Lmt, {7, 3, 0x03ff}));
}

void SlmpServerRequestTest::refusalsKeepTheOrderOfTheirHeader()
{
    const auto judged = [](const QByteArray& datagram) {
        const auto accepted = decodeServerRequest(datagram, golden::sensor);
        if (accepted)
            return golden::accepts;
        return accepted.error().answer ? int(*accepted.error().answer) : golden::silent;
    };
    const auto frame = [](FrameType type, Command command, quint16 subcommand, quint8 network) {
        return encodeRequestFrame(golden::around(type, {command, subcommand, hex("00")}, {network, 255}));
    };
    // Silence before anything else: Node Search in LMT with a wrong length.
    QCOMPARE(judged(frame(FrameType::Lmt, Command::NodeSearch, 0, 1) + 'x'), golden::silent);
    QCOMPARE(judged(frame(FrameType::Mt, Command(0xffff), 0, 1) + 'x'), int(CompleteCode::RequestDataSize));
    QCOMPARE(judged(frame(FrameType::Mt, Command(0xffff), 0, 1)), int(CompleteCode::Request));
    QCOMPARE(judged(frame(FrameType::Mt, Command(0xffff), 0, 0)), int(CompleteCode::Command));
    QCOMPARE(judged(frame(FrameType::St, Command::DeviceInfoCompare, 9, 0)), int(CompleteCode::Request));
    QCOMPARE(judged(frame(FrameType::Mt, Command::DeviceInfoCompare, 9, 0)), int(CompleteCode::Command));
}

QTEST_APPLESS_MAIN(SlmpServerRequestTest)
#include "tst_slmp_server_request.moc"
