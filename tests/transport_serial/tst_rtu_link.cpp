#include "rtu_link_fixture.h"

using namespace lds;
using namespace lds::tests;
using catalog::ItemId;
using ports::FailureCode;
using ports::FrameMeaning;
using ports::LinkState;
using ports::Status;

/// A link over a serial line, on a pseudo-terminal.
class RtuLinkTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { ports::registerMetaTypes(); }
    void readsWritesAndPolls();
    void everyBytePassesThroughTheLog();
    void aUnitIsAskedForItsCoilsBeforeAnythingElse();
    void aRefusalIsARefusal();
    void viewOnlyNeverWrites();
    void aWriteIsNeverRepeated();
    void aReadIsRepeatedOnce();
};

void RtuLinkTest::readsWritesAndPolls()
{
    RtuLinkFixture f;
    f.openAll();
    f.line.registers[400101] = 0xee90; // −70,000, low word first
    f.line.registers[400102] = 0xfffe;
    const auto read = f.subject().read({ItemId::HighSetValue, ItemId::DeviceAddress});
    QTRY_COMPARE(f.subject().endings(read), 1);
    QCOMPARE(f.subject().outcome(read).status, Status::Done);
    QCOMPARE(f.subject().outcome(read).values.value(ItemId::HighSetValue), -70'000);
    const auto one = f.subject().write({{ItemId::OutputDelayTimerSetting, 77}}); // FC 06
    const auto two = f.subject().write({{ItemId::LowSetValue, -2}});             // FC 10h
    QTRY_COMPARE(f.subject().outcomes.size(), 3);
    QCOMPARE(f.subject().outcome(one).status, Status::Done);
    QCOMPARE(f.subject().outcome(two).status, Status::Done);
    QCOMPARE(f.line.registers.value(400123), quint16(77));
    QCOMPARE(f.line.registers.value(400103), quint16(0xfffe));
    QCOMPARE(f.line.registers.value(400104), quint16(0xffff));
    f.subject().link->poll(5);
    QTRY_VERIFY(f.subject().measurements.size() >= 10);
    f.subject().link->close();
    QTRY_COMPARE(f.subject().state(), LinkState::Closed);
}

void RtuLinkTest::everyBytePassesThroughTheLog()
{
    RtuLinkFixture f;
    f.openAll();
    f.log.frames.clear();
    const auto id = f.subject().read({ItemId::Span});
    QTRY_COMPARE(f.subject().endings(id), 1);
    QCOMPARE(f.log.frames.size(), 2);
    const ports::Frame& sent = f.log.frames.first();
    const ports::Frame& answer = f.log.frames.last();
    // The register of Span is 400116, so 0x73 on the wire.
    QCOMPARE(sent.bytes, ScriptedLine::frame(1, QByteArray::fromHex("0300730002")));
    QCOMPARE(answer.bytes, ScriptedLine::frame(1, QByteArray::fromHex("030427100000")));
    QCOMPARE(sent.protocol, QStringLiteral("Modbus RTU"));
    QCOMPARE(sent.peer, f.url(1).peer().toString());
    QCOMPARE(answer.meaning, FrameMeaning::Answer);
    QVERIFY(answer.roundTripNs > 0);
}

void RtuLinkTest::aUnitIsAskedForItsCoilsBeforeAnythingElse()
{
    RtuLinkFixture f;
    f.openAll();
    QCOMPARE(f.line.received.size(), 2);
    QVERIFY(f.line.received.first().isCoils());
    QCOMPARE(f.line.received.last().function(), 3);
    // Once is enough for as long as it answers.
    const auto id = f.subject().read({ItemId::Span});
    QTRY_COMPARE(f.subject().endings(id), 1);
    QCOMPARE(f.line.received.size(), 3);
}

void RtuLinkTest::aRefusalIsARefusal()
{
    RtuLinkFixture f;
    f.openAll();
    const auto refuse = [&f](const ScriptedLine::Received& request) {
        f.line.send(ScriptedLine::frame(1, QByteArray(1, char(request.function() | 0x80)) + char(3)));
    };
    f.line.next(refuse);
    f.line.next(refuse);
    f.line.next(refuse);
    const auto read = f.subject().read({ItemId::Span});
    const auto one = f.subject().write({{ItemId::OutputDelayTimerSetting, 77}});
    const auto two = f.subject().write({{ItemId::HighSetValue, 77}});
    QTRY_COMPARE(f.subject().outcomes.size(), 3);
    for (const auto id : {read, one, two}) {
        QCOMPARE(f.subject().outcome(id).status, Status::Refused);
        QCOMPARE(f.subject().outcome(id).failure.code, FailureCode::ValueRefused);
        QCOMPARE(f.subject().outcome(id).failure.wireCode, 3);
    }
}

void RtuLinkTest::viewOnlyNeverWrites()
{
    RtuLinkFixture f({1}, true);
    f.openAll();
    const auto id = f.subject().write({{ItemId::OutputDelayTimerSetting, 77}});
    QTRY_COMPARE(f.subject().endings(id), 1);
    QCOMPARE(f.subject().outcome(id).failure.code, FailureCode::ViewOnly);
    QCOMPARE(f.line.writes(), 0);
}

void RtuLinkTest::aWriteIsNeverRepeated()
{
    RtuLinkFixture f;
    f.openAll();
    f.line.next(lineSilence);
    const auto lost = f.subject().write({{ItemId::Teaching1stPoint, 0}});
    const auto after = f.subject().read({ItemId::Span});
    QTRY_COMPARE(f.subject().outcomes.size(), 2);
    QCOMPARE(f.subject().outcome(lost).status, Status::Unknown);
    QCOMPARE(f.subject().outcome(lost).failure.code, FailureCode::NoAnswer);
    QCOMPARE(f.subject().outcome(after).status, Status::Done);
    QCOMPARE(f.line.writes(), 1);
}

void RtuLinkTest::aReadIsRepeatedOnce()
{
    RtuLinkFixture f;
    f.openAll();
    f.line.received.clear();
    f.line.next(lineSilence);
    const auto repeated = f.subject().read({ItemId::Span});
    QTRY_COMPARE(f.subject().endings(repeated), 1);
    QCOMPARE(f.subject().outcome(repeated).status, Status::Done);
    QCOMPARE(f.line.data().size(), 2);
    f.line.next(lineSilence);
    f.line.next(lineSilence);
    const auto given = f.subject().read({ItemId::Span});
    QTRY_COMPARE(f.subject().endings(given), 1);
    QCOMPARE(f.subject().outcome(given).status, Status::Unknown);
    QCOMPARE(f.line.data().size(), 4);
}

QTEST_GUILESS_MAIN(RtuLinkTest)
#include "tst_rtu_link.moc"
