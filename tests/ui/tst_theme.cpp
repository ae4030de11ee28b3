#include "theme.h"

#include <cmath>
#include <QApplication>
#include <QDir>
#include <QSignalSpy>
#include <QTest>

using namespace lds::ui;
using namespace Qt::StringLiterals;

/// Relative luminance and contrast as the web accessibility guidelines define them.
static double luminance(const QColor& color)
{
    const auto part = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * part(color.redF()) + 0.7152 * part(color.greenF()) + 0.0722 * part(color.blueF());
}
static double contrast(ColorRole a, ColorRole b)
{
    const double first = luminance(color(a));
    const double second = luminance(color(b));
    return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

class ThemeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void textCanBeReadOnWhatItStandsOn_data()
    {
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }
    void textCanBeReadOnWhatItStandsOn()
    {
        QFETCH(bool, dark);
        Theme::instance().setMode(dark ? ThemeMode::Dark : ThemeMode::Light);
        QCOMPARE(Theme::instance().isDark(), dark);
        using R = ColorRole;
        const QList<std::pair<R, R>> pairs{{R::Text, R::Panel},
                                           {R::Text, R::Background},
                                           {R::Text, R::Edit},
                                           {R::Text, R::AccentSoft},
                                           {R::Muted, R::Panel},
                                           {R::Muted, R::Background},
                                           {R::Muted, R::AccentSoft},
                                           {R::AccentText, R::Accent},
                                           {R::Warning, R::Edit},
                                           {R::Warning, R::Panel},
                                           {R::Error, R::Panel},
                                           {R::Go, R::Panel},
                                           {R::High, R::Panel},
                                           {R::Low, R::Panel},
                                           {R::Display, R::DisplayBackground},
                                           {R::DisplayDim, R::DisplayBackground},
                                           {R::DisplayMuted, R::DisplayBackground},
                                           {R::DisplayWarning, R::DisplayBackground},
                                           {R::DisplayGoText, R::DisplayGo},
                                           {R::DisplayGoText, R::DisplayHigh},
                                           {R::DisplayGoText, R::DisplayLow},
                                           {R::DisplayBackground, R::DisplayLit},
                                           {R::DisplayBackground, R::DisplayLaser}};
        for (const auto& [ink, paper] : pairs)
            QVERIFY2(
                contrast(ink, paper) >= 4.5,
                qPrintable(
                    u"role %1 on role %2: %3"_s.arg(int(ink)).arg(int(paper)).arg(contrast(ink, paper))));
    }

    void everyIconIsDrawnInTheTextColourOfTheTheme()
    {
        const QStringList files = QDir(u":/lds/icons"_s).entryList();
        QVERIFY(files.size() > 40);
        for (const QString& file : files) {
            const QIcon icon = Theme::instance().icon(file.chopped(4));
            Theme::instance().setMode(ThemeMode::Light);
            const QImage light = icon.pixmap(16, 16).toImage();
            Theme::instance().setMode(ThemeMode::Dark);
            const QImage dark = icon.pixmap(16, 16).toImage();
            QVERIFY2(!light.isNull() && light != dark, qPrintable(file));
            bool isBlank = true;
            for (int y = 0; y < light.height(); ++y) {
                for (int x = 0; x < light.width(); ++x)
                    isBlank = isBlank && qAlpha(light.pixel(x, y)) == 0;
            }
            QVERIFY2(!isBlank, qPrintable(file));
        }
        QVERIFY(Theme::instance().icon(u"no such icon"_s).isNull());
    }

    void changingTheModeIsTold()
    {
        Theme::instance().setMode(ThemeMode::Light);
        QSignalSpy changed(&Theme::instance(), &Theme::changed);
        Theme::instance().setMode(ThemeMode::Dark);
        QCOMPARE(changed.count(), 1);
        Theme::instance().setMode(ThemeMode::Dark);
        QCOMPARE(changed.count(), 1);
    }

    void figuresAreOfOneWidthBoldOrNot()
    {
        for (const bool bold : {false, true}) {
            const QFontMetricsF metrics(Theme::instance().numberFont(10, bold));
            for (const QChar digit : u"023456789"_s)
                QCOMPARE(metrics.horizontalAdvance(digit), metrics.horizontalAdvance(u'1'));
        }
    }
};

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    Theme::instance().apply(application, ThemeMode::Light);
    ThemeTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_theme.moc"
