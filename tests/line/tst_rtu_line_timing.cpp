// How long everything takes on a line, at all five speeds (§6.2; Modbus over serial line V1.02, 2.5.1.1).
#include "line_fixture.h"

using namespace lds::catalog;
using namespace lds::emulator;
using namespace lds::test;

class RtuLineTimingTest : public LineFixture {
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void anAnswerTakesTheTimeOfTheLine_data() { speeds(); }
    void anAnswerTakesTheTimeOfTheLine();
    void noByteComesBeforeItsTime_data() { speeds(); }
    void noByteComesBeforeItsTime();
    void theLongestAnswerTakesItsTime_data() { speeds(); }
    void theLongestAnswerTakesItsTime();
    void theAnsweringTimeComesBetween();
    void aRequestInPartsIsTimedByItsLastByte();
    void aPauseWithinARequestSpoilsIt_data() { speeds(); }
    void aPauseWithinARequestSpoilsIt();
    void noiseUntilSilenceHidesARequest();
    void aSavingSensorAnswersWhenItIsDone();
    void aSensorThatOwesAnAnswerHearsNothing();
    void aLateTimerDoesNotMakeTheLineSlower();
    void noTimerIsLeftBehind();

private:
    static void speeds();
    /// Everything between the request's arrival and the answer's first character.
    static qint64 beforeAnswer(const QByteArray& request, const LineSettings& settings)
    {
        return lds::modbus::charactersNs(settings.rate(), request.size()) +
               lds::modbus::frameSilenceNs(settings.rate());
    }
};

void RtuLineTimingTest::speeds()
{
    QTest::addColumn<int>("speed");
    QTest::addColumn<qint64>("wholeNs"); // 8 characters, the silence, 9 characters
    QTest::newRow("9600") << 9600 << 9'166'667 + 4'010'417 + 10'312'500LL;
    QTest::newRow("19200") << 19200 << 4'583'334 + 2'005'209 + 5'156'250LL;
    QTest::newRow("38400") << 38400 << 2'291'667 + 1'750'000 + 2'578'125LL;
    QTest::newRow("115200") << 115200 << 763'889 + 1'750'000 + 859'375LL;
    QTest::newRow("230400") << 230400 << 381'945 + 1'750'000 + 429'688LL;
}

void RtuLineTimingTest::anAnswerTakesTheTimeOfTheLine()
{
    QFETCH(int, speed);
    QFETCH(qint64, wholeNs);
    m_terminal->settings = LineSettings{speed, LineParity::None};
    add(1, *m_terminal->settings);
    const qint64 began = now();
    send(readSpan(1));
    m_clock->advanceNs(wholeNs - 1);
    QVERIFY(m_terminal->taken().size() < spanAnswer(1).size());
    m_clock->advanceNs(1);
    QCOMPARE(m_terminal->taken(), spanAnswer(1));
    QCOMPARE(m_terminal->portions.back().timeNs - began, wholeNs);
}

void RtuLineTimingTest::noByteComesBeforeItsTime()
{
    QFETCH(int, speed);
    m_terminal->settings = LineSettings{speed, LineParity::Odd};
    add(1, *m_terminal->settings);
    const auto rate = m_terminal->settings->rate();
    const QByteArray request = readRegisters(1, 400101, 60);
    const qint64 answerNs = now() + beforeAnswer(request, *m_terminal->settings);
    ask(request);
    QCOMPARE(m_terminal->taken().size(), 125);
    qsizetype count = 0;
    for (const FakeTerminal::Portion& portion : m_terminal->portions) {
        count += portion.bytes.size();
        // Exactly when its last byte is over; and no portion holds back more than a millisecond of bytes.
        QCOMPARE(portion.timeNs, answerNs + lds::modbus::charactersNs(rate, count));
        QVERIFY(portion.bytes.size() == 1 ||
                lds::modbus::charactersNs(rate, portion.bytes.size()) <= 1'000'000);
    }
}

void RtuLineTimingTest::theLongestAnswerTakesItsTime()
{
    QFETCH(int, speed);
    m_terminal->settings = LineSettings{speed, LineParity::Even};
    add(1, *m_terminal->settings);
    const QByteArray request = readRegisters(1, 400020, 125);
    const qint64 began = now();
    ask(request);
    QCOMPARE(m_terminal->taken().size(), 255);
    QVERIFY(lds::modbus::decodeRtuFrame(m_terminal->taken()).has_value());
    QCOMPARE(m_terminal->portions.back().timeNs - began,
             beforeAnswer(request, *m_terminal->settings) +
                 lds::modbus::charactersNs(m_terminal->settings->rate(), 255));
}

void RtuLineTimingTest::theAnsweringTimeComesBetween()
{
    add(1);
    unit().setAnsweringTime(7);
    const qint64 began = now();
    ask(readSpan(1));
    QCOMPARE(m_terminal->portions.back().timeNs - began, 2'291'667 + 1'750'000 + 7'000'000 + 2'578'125LL);
}

void RtuLineTimingTest::aRequestInPartsIsTimedByItsLastByte()
{
    add(1);
    const qint64 began = now();
    send(readSpan(1).first(3)); // on the line for 859,375 ns
    m_clock->advanceNs(859'375 + 750'000);
    send(readSpan(1).mid(3));
    m_clock->advanceMs(100);
    QCOMPARE(m_terminal->taken(), spanAnswer(1));
    QCOMPARE(m_terminal->portions.back().timeNs - began,
             859'375 + 750'000 + 1'432'292 + 1'750'000 + 2'578'125LL);
}

void RtuLineTimingTest::aPauseWithinARequestSpoilsIt()
{
    QFETCH(int, speed);
    m_terminal->settings = LineSettings{speed, LineParity::Even};
    add(1, *m_terminal->settings);
    const auto rate = m_terminal->settings->rate();
    send(readSpan(1).first(3));
    m_clock->advanceNs(lds::modbus::charactersNs(rate, 3) + lds::modbus::longestGapNs(rate) + 1);
    QCOMPARE(ask(readSpan(1).mid(3)), QByteArray());
    QCOMPARE(m_line->noiseCount(), 1);
    QCOMPARE(ask(readSpan(1)), spanAnswer(1));
}

void RtuLineTimingTest::noiseUntilSilenceHidesARequest()
{
    add(1);
    send("\xff\x07");
    m_clock->advanceMs(2); // 0.57 ms of characters and not yet 1.75 ms of silence
    QCOMPARE(ask(readSpan(1)), QByteArray());
    send("\xff\x07");
    m_clock->advanceMs(3);
    QCOMPARE(ask(readSpan(1)), spanAnswer(1));
    QCOMPARE(m_line->noiseCount(), 2);
}

void RtuLineTimingTest::aSavingSensorAnswersWhenItIsDone()
{
    add(1);
    sensor().setSavingDuration(800);
    const QByteArray save = writeRegister(1, setValueSaving, 0);
    send(save);
    m_clock->advanceMs(800);
    QCOMPARE(m_terminal->taken(), QByteArray());
    m_clock->advanceMs(10);
    QCOMPARE(m_terminal->taken(), save);
}

void RtuLineTimingTest::aSensorThatOwesAnAnswerHearsNothing()
{
    add(1);
    add(2);
    unit(0).setAnsweringTime(100);
    send(readSpan(1));
    m_clock->advanceMs(10);
    send(writeRegister(1, ecoMode, 0));
    m_clock->advanceMs(20);
    QCOMPARE(sensor(0).totalWriteCount(), 0);
    send(readSpan(2));
    m_clock->advanceMs(20);
    QCOMPARE(m_terminal->taken(), spanAnswer(2)); // the others do
    m_clock->advanceMs(100);
    QCOMPARE(m_terminal->taken(), spanAnswer(2) + spanAnswer(1));
}

/// The program is held up: what is over on the line by then comes at once, and not later by the delay.
void RtuLineTimingTest::aLateTimerDoesNotMakeTheLineSlower()
{
    class LateClock final : public EmulatorClock {
    public:
        explicit LateClock(ManualClock& clock)
            : m_clock(clock)
        {}
        qint64 nowNs() const override { return m_clock.nowNs(); }
        TimerId after(int delayMs, QObject* owner, std::function<void()> callback) override
        {
            return m_clock.after(delayMs, owner, std::move(callback));
        }
        TimerId at(qint64 timeNs, QObject* owner, std::function<void()> callback) override
        {
            return m_clock.at(timeNs + 600'000, owner, std::move(callback));
        }
        void cancel(TimerId timer) override { m_clock.cancel(timer); }

    private:
        ManualClock& m_clock;
    };
    LateClock late(*m_clock);
    m_line = std::make_unique<RtuLine>(*m_terminal, late);
    m_terminal->settings = LineSettings{9600, LineParity::Even};
    add(1, *m_terminal->settings);
    const qint64 began = now();
    QCOMPARE(ask(readSpan(1)), spanAnswer(1));
    QCOMPARE(m_terminal->portions.back().timeNs - began, 9'166'667 + 4'010'417 + 10'312'500 + 600'000LL);
}

void RtuLineTimingTest::noTimerIsLeftBehind()
{
    add(1);
    const int own = m_clock->pending(); // the sensor's
    for (const QByteArray& bytes :
         {readSpan(1), readSpan(2), QByteArray("noise"), writeRegister(0, ecoMode, 1)}) {
        ask(bytes);
        QCOMPARE(m_clock->pending(), own);
    }
}

QTEST_GUILESS_MAIN(RtuLineTimingTest)
#include "tst_rtu_line_timing.moc"
