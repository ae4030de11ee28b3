// What goes wrong on purpose, for every function code: and then the next request works.
#include "line_fixture.h"

using namespace lds::catalog;
using namespace lds::emulator;
using namespace lds::test;

class RtuLineFaultsTest : public LineFixture {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { tearDown(); }

    void slowAnswersComeLate_data() { requests(); }
    void slowAnswersComeLate();
    void lostAnswersWereCarriedOut_data() { requests(); }
    void lostAnswersWereCarriedOut();
    void cutAnswersLackTheirEnd_data() { requests(); }
    void cutAnswersLackTheirEnd();
    void aFlippedBitIsOneBit_data() { requests(); }
    void aFlippedBitIsOneBit();
    void aLostByteIsOneByte_data() { requests(); }
    void aLostByteIsOneByte();
    void noiseComesBeforeTheAnswer_data() { requests(); }
    void noiseComesBeforeTheAnswer();
    void anotherUnitsAnswerIsWellFormed_data() { requests(); }
    void anotherUnitsAnswerIsWellFormed();
    void anIgnoredRequestIsNotCarriedOut();
    void aDroppedUnitFallsSilentInTheMiddle();
    void aDroppedUnitCarriesNothingOut();
    void aPowerCycleLosesTheAnswer();
    void oneUnitsFaultsLeaveTheOthersAlone();

private:
    static void requests();
};

void RtuLineFaultsTest::init()
{
    setUp();
    add(1);
    add(2);
    sensor().placeWorkpiece(0);
}

void RtuLineFaultsTest::requests()
{
    QTest::addColumn<QByteArray>("request");
    QTest::newRow("01") << frame(1, hex("01 0000 0040"));
    QTest::newRow("03") << readSpan(1);
    QTest::newRow("06") << writeRegister(1, ecoMode, 0);
    QTest::newRow("10") << frame(1, hex("10 0064 0004 08 1110 0000 eef0 ffff"));
    QTest::newRow("refused") << frame(1, hex("03 0032 0001"));
}

void RtuLineFaultsTest::slowAnswersComeLate()
{
    QFETCH(QByteArray, request);
    const QByteArray answer = ask(request);
    unit().setStandingFaults({.answerDelayMs = 300});
    const qint64 began = now();
    QCOMPARE(ask(request), answer);
    const qint64 lineNs = lds::modbus::charactersNs({}, request.size() + answer.size()) + 1'750'000;
    QVERIFY(std::abs(m_terminal->portions.back().timeNs - began - lineNs - 300'000'000) < 3);
    unit().setStandingFaults({});
    QCOMPARE(ask(request), answer);
}

void RtuLineFaultsTest::lostAnswersWereCarriedOut()
{
    QFETCH(QByteArray, request);
    const QByteArray answer = ask(request);
    const int writes = sensor().totalWriteCount();
    unit().setStandingFaults({.answersLost = true});
    QCOMPARE(ask(request), QByteArray());
    QCOMPARE(unit().totalRequestCount(), 2);
    QCOMPARE(sensor().totalWriteCount(), 2 * writes);
    unit().setStandingFaults({});
    unit().injectFault(Fault::DropAnswer);
    QCOMPARE(ask(request), QByteArray());
    QCOMPARE(ask(request), answer);
}

void RtuLineFaultsTest::cutAnswersLackTheirEnd()
{
    QFETCH(QByteArray, request);
    const QByteArray answer = ask(request);
    unit().setStandingFaults({.answersCut = true});
    QCOMPARE(ask(request), answer.chopped(2));
    unit().setStandingFaults({});
    unit().injectFault(Fault::CutAnswer);
    QCOMPARE(ask(request), answer.chopped(2));
    QCOMPARE(ask(request), answer);
}

void RtuLineFaultsTest::aFlippedBitIsOneBit()
{
    QFETCH(QByteArray, request);
    const QByteArray answer = ask(request);
    unit().injectFault(Fault::FlipBit);
    const QByteArray flipped = ask(request);
    QCOMPARE(flipped.size(), answer.size());
    int different = 0;
    for (qsizetype i = 0; i < answer.size(); ++i)
        different += qPopulationCount(quint8(answer.at(i) ^ flipped.at(i)));
    QCOMPARE(different, 1);
    QCOMPARE(ask(request), answer);
}

void RtuLineFaultsTest::aLostByteIsOneByte()
{
    QFETCH(QByteArray, request);
    const QByteArray answer = ask(request);
    unit().injectFault(Fault::LoseByte);
    const QByteArray shorter = ask(request);
    QCOMPARE(shorter.size(), answer.size() - 1);
    QVERIFY(!lds::modbus::decodeRtuFrame(shorter));
    QCOMPARE(ask(request), answer);
}

void RtuLineFaultsTest::noiseComesBeforeTheAnswer()
{
    QFETCH(QByteArray, request);
    const QByteArray answer = ask(request);
    unit().injectFault(Fault::NoiseBefore);
    QCOMPARE(ask(request), hex("ff00fe") + answer);
    QCOMPARE(ask(request), answer);
}

void RtuLineFaultsTest::anotherUnitsAnswerIsWellFormed()
{
    QFETCH(QByteArray, request);
    const QByteArray answer = ask(request);
    unit().injectFault(Fault::OtherUnit);
    const auto other = lds::modbus::decodeRtuFrame(ask(request));
    QVERIFY(other.has_value());
    QCOMPARE(other->unit, quint8(2));
    QCOMPARE(other->pdu, answer.sliced(1).chopped(2));
    QCOMPARE(ask(request), answer);
}

void RtuLineFaultsTest::anIgnoredRequestIsNotCarriedOut()
{
    unit().injectFault(Fault::IgnoreRequest, FaultOn::Writes, 2);
    QCOMPARE(ask(readSpan(1)), spanAnswer(1));
    const QByteArray write = writeRegister(1, ecoMode, 0);
    QCOMPARE(ask(write), QByteArray());
    QCOMPARE(ask(write), QByteArray());
    QCOMPARE(sensor().totalWriteCount(), 0);
    QCOMPARE(ask(write), write);
}

void RtuLineFaultsTest::aDroppedUnitFallsSilentInTheMiddle()
{
    send(readSpan(1));
    m_clock->advanceNs(2'291'667 + 1'750'000 + 3 * 286'459);
    QCOMPARE(m_terminal->taken(), spanAnswer(1).first(3));
    unit().setStandingFaults({.connectionsDropped = true});
    m_clock->advanceMs(1000);
    QCOMPARE(m_terminal->taken(), spanAnswer(1).first(3));
    QCOMPARE(ask(readSpan(2)), spanAnswer(2));
    unit().setStandingFaults({});
    QCOMPARE(ask(readSpan(1)), spanAnswer(1));
}

void RtuLineFaultsTest::aDroppedUnitCarriesNothingOut()
{
    unit().setStandingFaults({.connectionsDropped = true});
    QCOMPARE(ask(writeRegister(1, ecoMode, 0)), QByteArray());
    QCOMPARE(ask(writeRegister(0, ecoMode, 0)), QByteArray());
    QCOMPARE(sensor(0).totalWriteCount(), 0);
    QCOMPARE(sensor(1).totalWriteCount(), 1);
}

void RtuLineFaultsTest::aPowerCycleLosesTheAnswer()
{
    unit().setAnsweringTime(50);
    send(readSpan(1));
    m_clock->advanceMs(20);
    QCOMPARE(unit().totalRequestCount(), 1);
    sensor().powerCycle();
    m_clock->advanceMs(1000);
    QCOMPARE(m_terminal->taken(), QByteArray());
    QCOMPARE(ask(readSpan(1)), spanAnswer(1));
}

void RtuLineFaultsTest::oneUnitsFaultsLeaveTheOthersAlone()
{
    unit(0).setStandingFaults({.answerDelayMs = 500, .answersCut = true});
    unit(0).injectFault(Fault::FlipBit, FaultOn::AnyRequest, 10);
    QCOMPARE(ask(readSpan(2)), spanAnswer(2));
}

QTEST_GUILESS_MAIN(RtuLineFaultsTest)
#include "tst_rtu_line_faults.moc"
