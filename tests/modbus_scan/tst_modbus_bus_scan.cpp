#include "fake_link.h"
#include "modbus_bus_scan.h"
#include "modbus_rtu_framing.h"
#include "scripted_line.h"
#include "serial_choices.h"

#include <QtTest>

using namespace lds;
using namespace lds::modbus;
using ports::ScanEnd;
using ports::ScanFinding;
using ports::SerialParity;
using ports::SerialSettings;
using Kind = ports::ScanFinding::Kind;

namespace {

const SerialSettings asDelivered{38'400, SerialParity::Even};
const SerialSettings fast{230'400, SerialParity::None};

QByteArray spanFrame(int unit) { return encodeRtuFrame(quint8(unit), QByteArray::fromHex("030427100000")); }
int unitOf(const ScriptedLine::Asked& asked)
{
    return asked.request.isEmpty() ? -1 : quint8(asked.request.at(0));
}

} // namespace

class ModbusBusScanTest : public QObject {
    Q_OBJECT

    ScriptedLine::Script m_script;
    std::unique_ptr<ModbusBusScan> m_scan;
    QList<ScanFinding> m_found;
    QList<ports::ScanProgress> m_progress;
    QList<ScanEnd> m_ends;
    QString m_detail;

    void start(const QList<SerialSettings>& settings, int first = 1, int last = 247)
    {
        m_scan->start({QStringLiteral("/dev/ttyUSB0"), settings, quint8(first), quint8(last)});
        support::settle();
    }
    int timesAsked(int unit) const
    {
        return int(std::ranges::count_if(m_script.asked,
                                         [unit](const auto& asked) { return unitOf(asked) == unit; }));
    }

private Q_SLOTS:
    void init()
    {
        m_script = {};
        m_found.clear();
        m_progress.clear();
        m_ends.clear();
        m_detail.clear();
        m_scan = std::make_unique<ModbusBusScan>(std::make_unique<ScriptedLine>(m_script), ScanTiming());
        connect(m_scan.get(), &ports::BusScan::found, this,
                [this](const ScanFinding& finding) { m_found.append(finding); });
        connect(m_scan.get(), &ports::BusScan::progressed, this,
                [this](const ports::ScanProgress& progress) { m_progress.append(progress); });
        connect(m_scan.get(), &ports::BusScan::finished, this, [this](ScanEnd end, const QString& detail) {
            m_ends.append(end);
            m_detail = detail;
        });
    }
    void cleanup() { m_scan.reset(); }

    void asksEveryUnitOfEachSettingInOrder()
    {
        start({asDelivered, fast}, 3, 5);
        QCOMPARE(m_ends, QList{ScanEnd::Complete});
        QCOMPARE(m_script.opened, (QList{asDelivered, fast}));
        QList<int> units;
        for (const auto& asked : m_script.asked) {
            if (unitOf(asked) >= 0)
                units.append(unitOf(asked));
        }
        QCOMPARE(units, (QList{3, 4, 5, 3, 4, 5}));
        QVERIFY(m_found.isEmpty());
        QVERIFY(!m_script.isOpen);
    }

    void saysHowFarItIs()
    {
        start({asDelivered, fast}, 3, 5);
        QCOMPARE(m_progress.first().asked, 0);
        QCOMPARE(m_progress.first().serial, asDelivered);
        QCOMPARE(m_progress.first().unit, 3);
        QCOMPARE(m_progress.last().asked, 6);
        for (const auto& progress : std::as_const(m_progress))
            QCOMPARE(progress.total, 6);
    }

    void findsSensorsAndOtherDevicesAsTheyAreAsked()
    {
        m_script.answer = [](const ScriptedLine::Asked& asked) {
            if (unitOf(asked) == 1 || unitOf(asked) == 16)
                return spanFrame(unitOf(asked));
            if (unitOf(asked) == 2)
                return encodeRtuFrame(2, QByteArray::fromHex("8304"));
            if (unitOf(asked) == 9)
                return encodeRtuFrame(9, QByteArray::fromHex("8302"));
            return QByteArray();
        };
        start({asDelivered});
        QCOMPARE(m_found, (QList{ScanFinding{Kind::Sensor, asDelivered, 1},
                                 ScanFinding{Kind::Sensor, asDelivered, 2}, // in its menu
                                 ScanFinding{Kind::OtherDevice, asDelivered, 9},
                                 ScanFinding{Kind::Sensor, asDelivered, 16}}));
        QCOMPARE(timesAsked(1), 1);
    }

    void theSettingsOfDeliveryTakeSeconds()
    {
        start({asDelivered});
        QCOMPARE(m_script.asked.size(), 248); // all units, and once nobody
        QVERIFY2(m_script.elapsedMs < 10'000, qPrintable(QString::number(m_script.elapsedMs)));
        m_script.elapsedMs = 0;
        start(ports::usualSerialSettings());
        QVERIFY2(m_script.elapsedMs < 60'000, qPrintable(QString::number(m_script.elapsedMs)));
    }

    void theSettingsOfDeliveryComeFirstThenTheirParityThenTheRest()
    {
        const QList<SerialSettings> all = ports::everySerialSettings();
        QCOMPARE(all.size(), 15);
        QCOMPARE(all.first(), asDelivered);
        QList<int> speeds;
        for (const SerialSettings& each : ports::usualSerialSettings()) {
            QCOMPARE(each.parity, SerialParity::Even);
            speeds.append(each.baud);
        }
        QCOMPARE(speeds, (QList{38'400, 230'400, 115'200, 19'200, 9'600}));
        QCOMPARE(all.at(5), fast);
        QCOMPARE(all.at(5).stopBits(), 2);
        QCOMPARE(all.at(10).parity, SerialParity::Odd);
    }

    void twoUnitsAreBytesForThisAddressOnly()
    {
        m_script.answer = [](const ScriptedLine::Asked& asked) {
            // Two answers on top of each other, a little different each time.
            return unitOf(asked) == 7 ? spanFrame(7).first(5) + spanFrame(7) : QByteArray();
        };
        start({asDelivered}, 6, 8);
        QCOMPARE(m_found, (QList{ScanFinding{Kind::TwoUnits, asDelivered, 7}}));
        QCOMPARE(timesAsked(7), 2);   // asked again to be sure
        QCOMPARE(timesAsked(248), 1); // and nobody has answered for nobody
    }

    void oneBrokenAnswerIsNoFinding()
    {
        int asked7 = 0;
        m_script.answer = [&](const ScriptedLine::Asked& asked) {
            if (unitOf(asked) != 7)
                return QByteArray();
            return ++asked7 == 1 ? spanFrame(7).first(5) : spanFrame(7);
        };
        start({asDelivered}, 6, 8);
        QCOMPARE(m_found, (QList{ScanFinding{Kind::Sensor, asDelivered, 7}}));
    }

    void bytesWithNothingAskedAreNoiseAndSaidOnce()
    {
        m_script.answer = [](const ScriptedLine::Asked&) { return QByteArray::fromHex("fe00fc"); };
        start({asDelivered, fast}, 1, 20);
        QCOMPARE(m_found,
                 (QList{ScanFinding{Kind::Noise, asDelivered, 0}, ScanFinding{Kind::Noise, fast, 0}}));
        QCOMPARE(m_ends, QList{ScanEnd::Complete});
    }

    void bytesWhoeverIsAskedAreNoise()
    {
        m_script.answer = [](const ScriptedLine::Asked& asked) {
            return asked.request.isEmpty() ? QByteArray() : QByteArray::fromHex("fe00fc");
        };
        start({asDelivered}, 1, 20);
        QCOMPARE(m_found, (QList{ScanFinding{Kind::Noise, asDelivered, 0}}));
    }

    void aSensorIsFoundOnANoisyLineToo()
    {
        m_script.answer = [](const ScriptedLine::Asked& asked) {
            return unitOf(asked) == 4 ? spanFrame(4) : QByteArray::fromHex("fe00fc");
        };
        start({asDelivered}, 1, 5);
        QCOMPARE(m_found, (QList{ScanFinding{Kind::Noise, asDelivered, 0},
                                 ScanFinding{Kind::Sensor, asDelivered, 4}}));
    }

    void anAnswerThatComesLateCountsForItsUnit()
    {
        int before = -1;
        m_script.answer = [&](const ScriptedLine::Asked& asked) {
            if (unitOf(asked) == 6)
                return before == 5 ? std::exchange(before, 6), spanFrame(5) : QByteArray();
            before = unitOf(asked);
            return QByteArray();
        };
        start({asDelivered}, 4, 7);
        QCOMPARE(m_found, (QList{ScanFinding{Kind::Sensor, asDelivered, 5}}));
        QCOMPARE(timesAsked(6), 2);
    }

    void aUnitThatAnswersForOthersDoesNotHoldTheScanUp()
    {
        m_script.answer = [](const ScriptedLine::Asked& asked) {
            return unitOf(asked) > 0 ? spanFrame(3) : QByteArray();
        };
        start({asDelivered}, 1, 10);
        QCOMPARE(m_ends, QList{ScanEnd::Complete});
        QCOMPARE(m_found, (QList{ScanFinding{Kind::Sensor, asDelivered, 3}}));
    }

    void cancelEndsAtOnceAndOnce()
    {
        m_script.answer = [this](const ScriptedLine::Asked& asked) {
            if (unitOf(asked) == 5)
                m_scan->cancel();
            return QByteArray();
        };
        start({asDelivered, fast});
        QCOMPARE(m_ends, QList{ScanEnd::Cancelled});
        QVERIFY(m_progress.last().asked <= 6);
        QVERIFY(!m_script.isOpen);
        m_scan->cancel();
        support::settle();
        QCOMPARE(m_ends.size(), 1);

        m_script.answer = [](const ScriptedLine::Asked&) { return QByteArray(); };
        start({asDelivered}, 1, 2); // and can be started again
        QCOMPARE(m_ends.last(), ScanEnd::Complete);
    }

    void aPortThatDoesNotOpenEndsTheScanWithItsReason()
    {
        m_script.refuseOpening = [](const SerialSettings&) { return QStringLiteral("Permission denied"); };
        start({asDelivered, fast});
        QCOMPARE(m_ends, QList{ScanEnd::PortFailed});
        QCOMPARE(m_detail, QStringLiteral("Permission denied"));
        QVERIFY(m_script.asked.isEmpty());
    }

    void aPortThatGoesAwayEndsTheScan()
    {
        m_script.breaks = [](const ScriptedLine::Asked& asked) { return unitOf(asked) == 3; };
        start({asDelivered, fast});
        QCOMPARE(m_ends, QList{ScanEnd::PortFailed});
        QCOMPARE(m_detail, QStringLiteral("Input/output error"));
        QCOMPARE(timesAsked(4), 0);
    }

    void aPlanWithNothingToAskIsComplete()
    {
        start({});
        start({asDelivered}, 9, 8);
        QCOMPARE(m_ends, (QList{ScanEnd::Complete, ScanEnd::Complete}));
        QVERIFY(m_script.opened.isEmpty());
    }

    void deletingItEndsItWithoutAWord()
    {
        m_scan->start({QStringLiteral("/dev/ttyUSB0"), {asDelivered}, 1, 247});
        m_scan.reset();
        support::settle();
        QVERIFY(m_ends.isEmpty());
        QVERIFY(!m_script.isOpen);
    }
};

QTEST_GUILESS_MAIN(ModbusBusScanTest)
#include "tst_modbus_bus_scan.moc"
