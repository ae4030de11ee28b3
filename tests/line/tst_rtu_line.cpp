// Who hears what on a line, and who answers (§6.2, §6.3).
#include "line_fixture.h"

using namespace lds::catalog;
using namespace lds::emulator;
using namespace lds::test;

class RtuLineTest : public LineFixture {
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void answersEveryFunction_data();
    void answersEveryFunction();
    void everyRegisterAndCoilIsThatOfModbusTcp();
    void sixteenUnitsShareALine();
    void aWrongCrcIsNotAnswered();
    void aShortOrLongMessageIsNotAnswered();
    void onlyTheUnitAddressedAnswers();
    void aUnitHearsItsOwnSpeedAndParityOnly_data();
    void aUnitHearsItsOwnSpeedAndParityOnly();
    void unitsOfDifferentSpeedsShareALine();
    void aChangedAddressCountsAfterACommunicationReset();
    void theAnswerToACommunicationResetGoesOutAtTheOldSettings();
    void aCommunicationResetByAllTakesEffectAtOnce();
    void aPowerCycleTakesTheSavedSettings();

    void allUnitsObeyABroadcast_data();
    void allUnitsObeyABroadcast();
    void aBroadcastReadIsIgnored();
    void aBroadcastOfAnotherSpeedIsNotHeard();

    void equalAnswersOfOneAddressCollide();
    void aCollisionIsAsLongAsTheLongerAnswer();
    void aLaterAnswerSpoilsTheRestOfTheFirst();
    void afterACollisionTheLineWorks();
    void aClientThatSpeaksDuringAnAnswerSpoilsBoth();
    void aClientThatChangesItsSpeedGetsGarbage();
    void aClientWithoutASpeedIsNotHeard();
    void aUnitThatIsGoneIsGone();
};

void RtuLineTest::answersEveryFunction_data()
{
    QTest::addColumn<QByteArray>("request");
    QTest::addColumn<QByteArray>("answer");
    const auto row = [](const char* name, const char* request, const char* answer) {
        QTest::newRow(name) << frame(1, hex(request)) << frame(1, hex(answer));
    };
    row("01", "01 0000 0040", "01 08 4804 0000 0000 0000"); // coils 4, 7, 11
    row("01 refused", "01 0040 0001", "81 02");
    row("03", "03 0064 0004", "03 08 c350 0000 3cb0 ffff");
    row("03 refused", "03 0032 0001", "83 02");
    row("03 of none", "03 0064 0000", "83 03");
    row("06", "06 006c 0000", "06 006c 0000");
    row("06 refused", "06 006c 0002", "86 03");
    row("06 that fails", "06 0091 0000", "86 04"); // a tuning point while no tuning runs
    row("10", "10 0064 0004 08 1110 0000 eef0 ffff", "10 0064 0004");
    row("10 refused", "10 0064 0004 08 0000 0000 0001 0000", "90 03");
    row("04", "04 0064 0001", "84 01");
}

void RtuLineTest::answersEveryFunction()
{
    QFETCH(QByteArray, request);
    QFETCH(QByteArray, answer);
    add(1);
    sensor().placeWorkpiece(0);
    QCOMPARE(ask(request).toHex(), answer.toHex());
}

/// §6.3.3 and §6.3.4 list what §5.2.4 and §5.2.5 do.
void RtuLineTest::everyRegisterAndCoilIsThatOfModbusTcp()
{
    add(1);
    sensor().placeWorkpiece(0);
    ModbusResponder tcp(sensor());
    const auto pdu = [](const char* function, int address) {
        return hex(function) + word(address) + word(1);
    };
    for (int address = 0; address < 200; ++address) {
        const QByteArray readRegister = pdu("03", address);
        QCOMPARE(ask(frame(1, readRegister)), frame(1, tcp.answer(readRegister)));
        const QByteArray readCoil = pdu("01", address);
        QCOMPARE(ask(frame(1, readCoil)), frame(1, tcp.answer(readCoil)));
    }
}

void RtuLineTest::sixteenUnitsShareALine()
{
    for (int address = 1; address <= 16; ++address)
        add(address);
    for (int address = 16; address >= 1; --address) {
        QCOMPARE(ask(writeRegister(address, 400110, 100 + address)),
                 writeRegister(address, 400110, 100 + address));
    }
    for (int address = 1; address <= 16; ++address)
        QCOMPARE(ask(readRegisters(address, 400110, 1)), frame(address, hex("03 02") + word(100 + address)));
}

void RtuLineTest::aWrongCrcIsNotAnswered()
{
    add(1);
    const QByteArray request = writeRegister(1, ecoMode, 0);
    for (qsizetype byte = 0; byte < request.size(); ++byte) {
        QByteArray flipped = request;
        flipped[byte] = char(flipped.at(byte) ^ 1);
        QCOMPARE(ask(flipped), QByteArray());
    }
    QCOMPARE(ask(request.chopped(1)), QByteArray());
    QCOMPARE(sensor().totalWriteCount(), 0);
    QCOMPARE(m_line->frameCount(), 0);
    QCOMPARE(m_line->noiseCount(), int(request.size()) + 1);
    QCOMPARE(ask(request), request); // and then it works
}

void RtuLineTest::aShortOrLongMessageIsNotAnswered()
{
    add(1);
    QCOMPARE(ask("\x01"), QByteArray());
    QCOMPARE(ask(readSpan(1) + QByteArray(249, '\0')), QByteArray());
    QCOMPARE(ask(QByteArray(1000, '\x01')), QByteArray());
    QCOMPARE(unit().totalRequestCount(), 0);
    QCOMPARE(ask(readSpan(1)), spanAnswer(1));
}

void RtuLineTest::onlyTheUnitAddressedAnswers()
{
    add(1);
    add(2);
    add(247);
    for (const int address : {2, 247, 1})
        QCOMPARE(ask(readSpan(address)), spanAnswer(address));
    QCOMPARE(ask(readSpan(3)), QByteArray());
    QCOMPARE(ask(readSpan(248)), QByteArray());
    for (std::size_t i = 0; i < 3; ++i)
        QCOMPARE(unit(i).totalRequestCount(), 1);
    QCOMPARE(ask(writeRegister(2, ecoMode, 0)), writeRegister(2, ecoMode, 0));
    QCOMPARE(sensor(0).memory().value(ItemId::EcoMode), 1);
    QCOMPARE(sensor(1).memory().value(ItemId::EcoMode), 0);
}

void RtuLineTest::aUnitHearsItsOwnSpeedAndParityOnly_data()
{
    QTest::addColumn<int>("speed");
    QTest::addColumn<LineParity>("parity");
    for (const int speed : {9600, 19200, 38400, 115200, 230400}) {
        QTest::addRow("%d none", speed) << speed << LineParity::None;
        QTest::addRow("%d even", speed) << speed << LineParity::Even;
        QTest::addRow("%d odd", speed) << speed << LineParity::Odd;
    }
}

void RtuLineTest::aUnitHearsItsOwnSpeedAndParityOnly()
{
    QFETCH(int, speed);
    QFETCH(LineParity, parity);
    const LineSettings own{speed, parity};
    add(1, own);
    for (const int other : {9600, 19200, 38400, 57600, 115200, 230400}) {
        for (const LineParity otherParity : {LineParity::None, LineParity::Even, LineParity::Odd}) {
            const LineSettings client{other, otherParity};
            m_terminal->settings = client;
            QCOMPARE(ask(readSpan(1)), client == own ? spanAnswer(1) : QByteArray());
        }
    }
    QCOMPARE(unit().totalRequestCount(), 1);
}

void RtuLineTest::unitsOfDifferentSpeedsShareALine()
{
    const LineSettings fast{230400, LineParity::Odd};
    add(1);
    add(1, fast);
    QCOMPARE(ask(readSpan(1)), spanAnswer(1));
    m_terminal->settings = fast;
    QCOMPARE(ask(readSpan(1)), spanAnswer(1));
    QCOMPARE(unit(0).totalRequestCount(), 1);
    QCOMPARE(unit(1).totalRequestCount(), 1);
}

void RtuLineTest::aChangedAddressCountsAfterACommunicationReset()
{
    add(1);
    QCOMPARE(ask(writeRegister(1, deviceAddress, 17)), writeRegister(1, deviceAddress, 17));
    QCOMPARE(ask(readSpan(17)), QByteArray());
    QCOMPARE(ask(readSpan(1)), spanAnswer(1));
    ask(writeRegister(1, communicationReset, 0));
    QCOMPARE(ask(readSpan(1)), QByteArray());
    QCOMPARE(ask(readSpan(17)), spanAnswer(17));
}

void RtuLineTest::theAnswerToACommunicationResetGoesOutAtTheOldSettings()
{
    add(1);
    unit().setAnsweringTime(20);
    ask(writeRegister(1, deviceAddress, 2));
    ask(writeRegister(1, communicationSpeed, 0));
    const QByteArray reset = writeRegister(1, communicationReset, 0);
    QCOMPARE(ask(reset), reset); // at 38,400 bps, from unit 1
    QCOMPARE(ask(readSpan(2)), QByteArray());
    m_terminal->settings = LineSettings{9600, LineParity::Even};
    QCOMPARE(ask(readSpan(2)), spanAnswer(2));
}

void RtuLineTest::aCommunicationResetByAllTakesEffectAtOnce()
{
    add(1);
    ask(writeRegister(1, deviceAddress, 9));
    QCOMPARE(ask(writeRegister(0, communicationReset, 0)), QByteArray());
    QCOMPARE(unit().address(), quint8(9));
    ask(writeRegister(9, deviceAddress, 10));
    sensor().changeByKeypad(ItemId::ResettingCommunicationSettings, 0);
    QCOMPARE(ask(readSpan(10)), spanAnswer(10));
}

void RtuLineTest::aPowerCycleTakesTheSavedSettings()
{
    add(5);
    ask(writeRegister(5, deviceAddress, 6));
    ask(writeRegister(5, communicationReset, 0));
    QCOMPARE(ask(readSpan(6)), spanAnswer(6));
    sensor().powerCycle();
    QCOMPARE(ask(readSpan(6)), QByteArray());
    QCOMPARE(ask(readSpan(5)), spanAnswer(5));
}

void RtuLineTest::allUnitsObeyABroadcast_data()
{
    QTest::addColumn<QByteArray>("pdu");
    QTest::newRow("06") << hex("06 006c 0000");
    QTest::newRow("10") << hex("10 006c 0001 02 0000");
}

void RtuLineTest::allUnitsObeyABroadcast()
{
    QFETCH(QByteArray, pdu);
    for (int address = 1; address <= 16; ++address)
        add(address);
    QCOMPARE(ask(frame(0, pdu)), QByteArray());
    for (std::size_t i = 0; i < 16; ++i)
        QCOMPARE(sensor(i).memory().value(ItemId::EcoMode), 0);
    QCOMPARE(ask(readSpan(16)), spanAnswer(16));
}

void RtuLineTest::aBroadcastReadIsIgnored()
{
    add(1);
    QCOMPARE(ask(readSpan(0)), QByteArray());
    QCOMPARE(ask(frame(0, hex("01 0000 0001"))), QByteArray());
    QCOMPARE(ask(frame(0, hex("04 0000 0001"))), QByteArray());
    QCOMPARE(unit().totalRequestCount(), 0);
    QCOMPARE(m_line->frameCount(), 3);
}

void RtuLineTest::aBroadcastOfAnotherSpeedIsNotHeard()
{
    add(1);
    add(2, {9600, LineParity::None});
    ask(writeRegister(0, ecoMode, 0));
    QCOMPARE(sensor(0).memory().value(ItemId::EcoMode), 0);
    QCOMPARE(sensor(1).memory().value(ItemId::EcoMode), 1);
}

void RtuLineTest::equalAnswersOfOneAddressCollide()
{
    add(3);
    add(3);
    const QByteArray answer = ask(readSpan(3));
    QCOMPARE(answer.size(), spanAnswer(3).size());
    QVERIFY(answer != spanAnswer(3));
    QVERIFY(!lds::modbus::decodeRtuFrame(answer));
    QCOMPARE(unit(0).totalRequestCount(), 1);
    QCOMPARE(unit(1).totalRequestCount(), 1);
}

void RtuLineTest::aCollisionIsAsLongAsTheLongerAnswer()
{
    add(3);
    add(3);
    sensor(0).setInMenu(true); // answers with five bytes
    const QByteArray answer = ask(readSpan(3));
    QCOMPARE(answer.size(), spanAnswer(3).size());
    QVERIFY(!lds::modbus::decodeRtuFrame(answer));
    QVERIFY(!lds::modbus::decodeRtuFrame(answer.first(5)));
}

void RtuLineTest::aLaterAnswerSpoilsTheRestOfTheFirst()
{
    const LineSettings slow{9600, LineParity::Even};
    add(3, slow);
    add(3, slow);
    m_terminal->settings = slow;
    unit(1).setAnsweringTime(5); // within the fifth character
    const QByteArray first = spanAnswer(3);
    const QByteArray answer = ask(readSpan(3));
    QCOMPARE(answer.first(4), first.first(4));
    QVERIFY(answer.mid(4, 5) != first.mid(4));
    QCOMPARE(answer.size(), 4 + first.size());
}

void RtuLineTest::afterACollisionTheLineWorks()
{
    add(3);
    add(3);
    add(4);
    ask(readSpan(3));
    QCOMPARE(ask(readSpan(4)), spanAnswer(4));
    sensor(1).changeByKeypad(ItemId::DeviceAddress, 5);
    sensor(1).powerCycle();
    QCOMPARE(ask(readSpan(3)), spanAnswer(3));
    QCOMPARE(ask(readSpan(5)), spanAnswer(5));
}

void RtuLineTest::aClientThatSpeaksDuringAnAnswerSpoilsBoth()
{
    const LineSettings slow{9600, LineParity::Even};
    add(1, slow);
    add(2, slow);
    m_terminal->settings = slow;
    send(readSpan(1));
    m_clock->advanceNs(9'166'667 + 4'010'417 + 3 * 1'145'834); // three characters of the answer are out
    QCOMPARE(m_terminal->taken(), spanAnswer(1).first(3));
    send(readSpan(2));
    m_clock->advanceMs(1000);
    QCOMPARE(m_terminal->taken().size(), spanAnswer(1).size());
    QVERIFY(m_terminal->taken() != spanAnswer(1));
    QCOMPARE(unit(1).totalRequestCount(), 0);
    QCOMPARE(ask(readSpan(2)), spanAnswer(2));
}

void RtuLineTest::aClientThatChangesItsSpeedGetsGarbage()
{
    add(1);
    unit().setAnsweringTime(10);
    send(readSpan(1));
    m_clock->advanceMs(5);
    m_terminal->settings = LineSettings{115200, LineParity::Even};
    m_clock->advanceMs(100);
    QCOMPARE(m_terminal->taken().size(), spanAnswer(1).size());
    for (qsizetype i = 0; i < spanAnswer(1).size(); ++i)
        QVERIFY(m_terminal->taken().at(i) != spanAnswer(1).at(i));
    QVERIFY(!lds::modbus::decodeRtuFrame(m_terminal->taken()));
}

void RtuLineTest::aClientWithoutASpeedIsNotHeard()
{
    add(1);
    m_terminal->settings.reset();
    QCOMPARE(ask(readSpan(1)), QByteArray());
    QCOMPARE(unit().totalRequestCount(), 0);
}

void RtuLineTest::aUnitThatIsGoneIsGone()
{
    add(1);
    add(2);
    unit(0).setAnsweringTime(50);
    send(readSpan(1));
    m_clock->advanceMs(10);
    QCOMPARE(unit(0).totalRequestCount(), 1);
    m_stations.erase(m_stations.begin());
    m_clock->advanceMs(1000);
    QCOMPARE(m_terminal->taken(), QByteArray());
    QCOMPARE(m_line->unitCount(), 1);
    QCOMPARE(ask(readSpan(2)), spanAnswer(2));
}

QTEST_GUILESS_MAIN(RtuLineTest)
#include "tst_rtu_line.moc"
