#include "link_fixture.h"

using namespace lds;
using namespace lds::tests;
using catalog::ItemId;
using ports::Direction;
using ports::Frame;
using ports::FrameMeaning;
using Received = ScriptedServer::Received;

class LinkFramesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void bytesAreThoseOnTheWire();
    void readAndAnswerAreTold();
    void writeIsTold();
    void fourByteWriteIsToldAsAValue();
    void refusalIsTold();
    void missingAnswerIsTold();
    void strayAndBrokenAnswersAreTold();
    void comingAndGoingIsTold();
};

void LinkFramesTest::bytesAreThoseOnTheWire()
{
    LinkFixture f;
    f.openLink();
    for (int i = 0; i < 3; ++i) {
        const auto id = f.read({ItemId::HighSetValue});
        QTRY_COMPARE(f.endings(id), 1);
    }
    const QList<Frame> sent = f.log.frames(FrameMeaning::Read);
    const QList<Frame> received = f.log.frames(FrameMeaning::Answer);
    QCOMPARE(sent.size(), 4);
    QCOMPARE(received.size(), 4);
    for (int i = 0; i < 4; ++i) {
        const Received& onWire = f.server.received.at(i);
        QCOMPARE(sent.at(i).bytes, ScriptedServer::frame(onWire.transaction, onWire.unit, onWire.pdu));
        QCOMPARE(sent.at(i).reconstructedPrefix, 7);
        QCOMPARE(received.at(i).bytes, f.server.goodFrame(onWire));
        QCOMPARE(received.at(i).reconstructedPrefix, 0);
    }
}

void LinkFramesTest::readAndAnswerAreTold()
{
    LinkFixture f;
    f.openLink();
    f.server.registers[400101] = 0x8ce8;
    f.server.registers[400102] = 0xfffe;
    f.server.registers[400103] = 5;
    f.server.next(silence);
    const auto id = f.read({ItemId::HighSetValue, ItemId::LowSetValue});
    QTRY_VERIFY(f.serverHas(1));
    f.clock->advanceMs(3);
    f.server.send(f.server.goodFrame(f.server.received.last()));
    QTRY_COMPARE(f.endings(id), 1);
    const Frame sent = f.log.frames(FrameMeaning::Read).last();
    QCOMPARE(sent.direction, Direction::Sent);
    QCOMPARE(sent.arguments, (QStringList{QStringLiteral("400101"), QStringLiteral("400104")}));
    QCOMPARE(sent.roundTripNs, qint64(-1));
    QCOMPARE(sent.protocol, QStringLiteral("Modbus TCP"));
    QCOMPARE(sent.peer, QStringLiteral("modbus-tcp://127.0.0.1:%1").arg(f.server.port()));
    const Frame answer = f.log.frames(FrameMeaning::Answer).last();
    QCOMPARE(answer.direction, Direction::Received);
    QCOMPARE(answer.arguments, (QStringList{QStringLiteral("400101"), QStringLiteral("400104"),
                                            QStringLiteral("highSetValue=-95000, lowSetValue=5")}));
    QCOMPARE(answer.roundTripNs, qint64(3'000'000));
    QCOMPARE(answer.monotonicNs, f.clock->nowNs());
    QCOMPARE(answer.wallMs, f.clock->wallMs());
}

void LinkFramesTest::writeIsTold()
{
    LinkFixture f;
    f.openLink();
    const auto id = f.write({{ItemId::SetValueSaving, 0}});
    QTRY_COMPARE(f.endings(id), 1);
    QCOMPARE(f.log.frames(FrameMeaning::Write).last().arguments,
             (QStringList{QStringLiteral("400054"), QStringLiteral("400054"),
                          QStringLiteral("setValueSaving=0")}));
    QCOMPARE(f.log.frames(FrameMeaning::Written).last().arguments,
             (QStringList{QStringLiteral("400054"), QStringLiteral("400054")}));
}

void LinkFramesTest::fourByteWriteIsToldAsAValue()
{
    LinkFixture f;
    f.server.registers[400116] = 0;
    f.server.registers[400117] = 10'000; // High word first
    f.openLink();
    const auto id = f.write({{ItemId::HighSetValue, -70'000}});
    QTRY_COMPARE(f.endings(id), 1);
    QCOMPARE(f.log.frames(FrameMeaning::Write).last().arguments.last(),
             QStringLiteral("highSetValue=-70000"));
}

void LinkFramesTest::refusalIsTold()
{
    LinkFixture f;
    f.openLink();
    f.server.next([&f](const Received& request) { f.server.refuse(request, 3); });
    const auto id = f.write({{ItemId::HighSetValue, 1}});
    QTRY_COMPARE(f.endings(id), 1);
    const Frame refused = f.log.frames(FrameMeaning::Refused).last();
    QCOMPARE(refused.arguments, (QStringList{QStringLiteral("16"), QStringLiteral("3")}));
    QCOMPARE(refused.bytes.last(2), QByteArray::fromHex("90 03"));
    QVERIFY(refused.roundTripNs >= 0);
}

void LinkFramesTest::missingAnswerIsTold()
{
    LinkFixture f;
    f.openLink();
    f.server.next(silence);
    const auto id = f.write({{ItemId::KeyLock, 1}});
    QTRY_VERIFY(f.serverHas(1));
    f.clock->advanceMs(500);
    QTRY_COMPARE(f.endings(id), 1);
    const Frame missing = f.log.frames(FrameMeaning::NoAnswer).last();
    QCOMPARE(missing.arguments, QStringList{QStringLiteral("500")});
    QVERIFY(missing.bytes.isEmpty());
}

void LinkFramesTest::strayAndBrokenAnswersAreTold()
{
    LinkFixture f;
    f.openLink();
    const QByteArray stray = ScriptedServer::frame(99, 1, QByteArray::fromHex("83 02"));
    f.server.send(stray);
    QTRY_COMPARE(f.log.frames(FrameMeaning::Malformed).size(), 1);
    QCOMPARE(f.log.frames(FrameMeaning::Malformed).last().arguments,
             QStringList{QStringLiteral("transaction")});
    QCOMPARE(f.log.frames(FrameMeaning::Malformed).last().bytes, stray);
    f.server.send("nonsense");
    QTRY_COMPARE(f.log.frames(FrameMeaning::Malformed).size(), 2);
    QCOMPARE(f.log.frames(FrameMeaning::Malformed).last().arguments, QStringList{QStringLiteral("header")});
    QCOMPARE(f.log.frames(FrameMeaning::Malformed).last().bytes, QByteArray("nonsense"));
}

void LinkFramesTest::comingAndGoingIsTold()
{
    LinkFixture f;
    f.openLink();
    QCOMPARE(f.log.frames().first().meaning, FrameMeaning::Connecting);
    QCOMPARE(f.log.frames().first().arguments,
             (QStringList{QStringLiteral("127.0.0.1"), QString::number(f.server.port())}));
    QCOMPARE(f.log.frames().at(1).meaning, FrameMeaning::Connected);
    f.server.cut();
    QTRY_COMPARE(f.log.frames(FrameMeaning::Disconnected).size(), 1);
    QVERIFY(!f.log.frames().last().arguments.first().isEmpty());
    f.openLink();
    f.link->close();
    QTRY_COMPARE(f.log.frames(FrameMeaning::Disconnected).size(), 2);
    settle();
    QCOMPARE(f.log.frames(FrameMeaning::Disconnected).size(), 2);
}

QTEST_GUILESS_MAIN(LinkFramesTest)
#include "tst_link_frames.moc"
