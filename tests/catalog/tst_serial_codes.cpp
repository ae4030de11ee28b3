#include "serial_codes.h"

#include <QTest>

using namespace lds::catalog;

class SerialCodesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// §6.3.3, 400167 and 400168; a table of its own, since the catalog is what is being tested.
    void codesMeanWhatTheManualPrints()
    {
        const int speeds[] = {9600, 19'200, 38'400, 115'200, 230'400};
        for (Value code = 0; code < 5; ++code) {
            QCOMPARE(lineSpeed(code), std::optional(speeds[code]));
            QCOMPARE(lineSpeedCode(speeds[code]), std::optional(code));
        }
        const LineParity parities[] = {LineParity::None, LineParity::Even, LineParity::Odd};
        for (Value code = 0; code < 3; ++code) {
            QCOMPARE(lineParity(code), std::optional(parities[code]));
            QCOMPARE(lineParityCode(parities[code]), code);
        }
    }

    void otherCodesMeanNothing()
    {
        for (const Value code : {-1, 5, 255}) {
            QVERIFY(!lineSpeed(code));
            QVERIFY(!lineParity(code));
        }
        QVERIFY(!lineSpeedCode(57'600));
        QVERIFY(!lineSpeedCode(0));
    }
};

QTEST_APPLESS_MAIN(SerialCodesTest)
#include "tst_serial_codes.moc"
