#include "fake_link.h"
#include "manual_scheduler.h"
#include "readout.h"
#include "readout_painter.h"
#include "readout_state.h"
#include "theme.h"

#include <QApplication>
#include <QPainter>
#include <QTest>

using namespace lds;
using namespace lds::ui;
using namespace Qt::StringLiterals;
using catalog::ItemId;
using measurement::Measurement;
using measurement::ValueKind;

class ReadoutTest : public QObject {
    Q_OBJECT

    ports::ManualScheduler m_scheduler;
    std::unique_ptr<support::FakeLinkFactory> m_links;
    std::unique_ptr<sensor::SensorSession> m_session;
    ports::ConnectionUrl m_url;

    support::FakeSensor& device() { return m_links->sensor(m_url); }

    void open()
    {
        m_session->open();
        support::settle();
    }

    ReadoutState shown(Measurement sample)
    {
        sample.monotonicNs = m_scheduler.nowNs();
        sample.wallMs = m_scheduler.wallMs();
        device().emitMeasurement(sample);
        support::settle();
        return readoutState(m_session.get());
    }

    static Measurement good(catalog::Value value)
    {
        Measurement sample;
        sample.value = value;
        sample.kind = measurement::kindOf(value);
        sample.state = measurement::LaserBit | measurement::GoBit;
        sample.intensity = 552;
        return sample;
    }

private Q_SLOTS:
    void init()
    {
        m_links = std::make_unique<support::FakeLinkFactory>(m_scheduler);
        m_url = {};
        m_url.host = u"sensor"_s;
        m_url.sensor = catalog::SensorModel::HlG203;
        m_session = std::make_unique<sensor::SensorSession>(m_url, *m_links, m_scheduler);
    }

    void cleanup() { m_session.reset(); }

    void theValueHasTheDigitsTheDisplayIsSetToAndIsRoundedDown() // §4.8.1
    {
        const QStringList expected{u"+1.2399"_s, u"+1.239"_s, u"+1.23"_s, u"+1.2"_s};
        for (int code = 0; code < int(expected.size()); ++code) {
            init();
            device().set(ItemId::DisplayDigit, code);
            open();
            QCOMPARE(shown(good(12'399)).value, expected.at(code));
            cleanup();
        }
        QCOMPARE(displayDecimals(4), 0);
        QCOMPARE(displayDecimals(99), 0); // whatever a sensor may say
        QCOMPARE(displayDecimals(-3), 4);
    }

    void roundingDownGoesTowardsZeroOnBothSides()
    {
        device().set(ItemId::DisplayDigit, 3);
        open();
        QCOMPARE(shown(good(-12'999)).value, u"\u22121.2"_s);
    }

    void judgmentAndFlagsAreTheSensors()
    {
        device().set(ItemId::KeyLock, 1);
        device().set(ItemId::BankSwitching, 3);
        device().set(ItemId::HoldMode, 3);
        open();
        Measurement sample = good(10);
        sample.state =
            measurement::LaserBit | measurement::HighBit | measurement::HoldBit | measurement::ZeroBit;
        const ReadoutState state = shown(sample);
        QCOMPARE(state.judgment, Judgment::High);
        QVERIFY(state.laser && state.hold && state.zero && state.keyLock && state.isLive);
        QCOMPARE(state.bank, 3);
        QCOMPARE(state.holdModeLetter, u"PP"_s);
        QCOMPARE(state.intensity, std::optional(552));
        sample.state = measurement::LaserBit | measurement::LowBit;
        QCOMPARE(shown(sample).judgment, Judgment::Low);
        sample.state =
            measurement::LaserBit | measurement::HighNoTimerBit; // before the delay timer: not shown
        QCOMPARE(shown(sample).judgment, Judgment::None);
    }

    void aValueThatIsNoneIsTheDisplaysWord_data()
    {
        QTest::addColumn<int>("value");
        QTest::addColumn<QString>("word");
        QTest::newRow("over") << int(catalog::sentinel::over) << u"+OVER"_s;
        QTest::newRow("under") << int(catalog::sentinel::under) << u"\u2212OVER"_s;
        QTest::newRow("indeterminate") << int(catalog::sentinel::indeterminate) << u"----"_s;
        QTest::newRow("alarm") << int(catalog::sentinel::alarm) << u"ALARM"_s;
    }
    void aValueThatIsNoneIsTheDisplaysWord()
    {
        QFETCH(int, value);
        open();
        Measurement sample = good(value);
        if (value == catalog::sentinel::alarm)
            sample.state |= measurement::AlarmBit;
        sample.intensity = 65535;
        const ReadoutState state = shown(sample);
        QTEST(state.value, "word");
        QVERIFY(!state.isNumber);
        QVERIFY(!state.notice.isEmpty());
        QVERIFY(!state.intensity);
    }

    void aFrozenValueUnderAnAlarmIsMarkedAndSaysWhy() // §4.7.2
    {
        open();
        Measurement sample = good(500);
        sample.state |= measurement::AlarmBit;
        sample.notification = 1 << 1;
        const ReadoutState state = shown(sample);
        QVERIFY(state.isFrozen);
        QVERIFY2(state.notice.contains(u"frozen"_s) && state.notice.contains(u"nsufficient"_s),
                 qPrintable(state.notice));
    }

    void aStoppedLaserIsSaid()
    {
        open();
        Measurement sample = good(catalog::sentinel::indeterminate);
        sample.state = measurement::IndeterminateBit;
        const ReadoutState state = shown(sample);
        QVERIFY(!state.laser);
        QCOMPARE(state.notice, u"The laser is stopped"_s);
    }

    void anErrorCodeStandsInTheValuesPlace() // §2.2
    {
        open();
        Measurement sample = good(500);
        sample.errorCode = 0x0120;
        sample.state |= measurement::ErrorBit;
        const ReadoutState state = shown(sample);
        QCOMPARE(state.value, u"E120**"_s);
        QVERIFY(!state.isNumber);
    }

    void aLostConnectionLeavesTheLastValueAsNotLive()
    {
        open();
        QVERIFY(shown(good(12'345)).isLive);
        device().cut();
        support::settle();
        const ReadoutState state = readoutState(m_session.get());
        QVERIFY(!state.isLive);
        QCOMPARE(state.value, u"+1.2345"_s);
        QCOMPARE(state.judgment, Judgment::None); // its flags do not pretend to hold
        QVERIFY(!state.laser);
        QCOMPARE(state.bank, 0);
        QVERIFY2(state.notice.contains(u"reconnecting"_s), qPrintable(state.notice));
        QVERIFY(spokenText(state).contains(u"last value"_s));
    }

    void aSensorInItsMenuIsSaid()
    {
        open();
        shown(good(12'345));
        device().refusePoll(ports::FailureCode::NotReady);
        support::settle();
        const ReadoutState state = readoutState(m_session.get());
        QVERIFY(!state.isLive);
        QVERIFY2(state.notice.contains(u"menu"_s), qPrintable(state.notice));
    }

    void whatIsSpokenSaysItAll()
    {
        open();
        QCOMPARE(spokenText(shown(good(12'345))), u"+1.2345 mm, GO, laser on, bank 1"_s);
        QCOMPARE(spokenText(readoutState(nullptr)), u"No sensor"_s);
    }

    void theWidgetFollowsItsSessionAndSurvivesItsEnd()
    {
        Readout readout;
        QCOMPARE(readout.spokenText(), u"No sensor"_s);
        readout.setSession(m_session.get());
        open();
        shown(good(12'345));
        QTRY_COMPARE(readout.state().value, u"+1.2345"_s);
        m_session.reset();
        QCOMPARE(readout.spokenText(), u"No sensor"_s);
        readout.grab();
    }

    void highGoAndLowDifferInShapeNotOnlyInColour()
    {
        const auto picture = [](Judgment judgment) {
            ReadoutState state;
            state.isLive = true;
            state.judgment = judgment;
            QImage image(1000, 88, QImage::Format_ARGB32_Premultiplied);
            image.fill(Qt::transparent);
            QPainter painter(&image);
            paintReadout(&painter, image.rect(), state, qApp->font());
            painter.end();
            return image.convertToFormat(QImage::Format_Grayscale8).convertToFormat(QImage::Format_Mono);
        };
        QVERIFY(picture(Judgment::High) != picture(Judgment::Low));
        QVERIFY(picture(Judgment::High) != picture(Judgment::Go));
        QVERIFY(picture(Judgment::None) != picture(Judgment::Go));
    }
};

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    Theme::instance().apply(application, ThemeMode::Light);
    ports::registerMetaTypes();
    ReadoutTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_readout.moc"
