#include "display_painter.h"
#include "panel_fixture.h"
#include "panel_widget.h"

#include <QApplication>
#include <QDir>
#include <QImage>
#include <QPainter>
#include <QTest>

using namespace lds;
using namespace lds::catalog;
using namespace lds::test;
using namespace Qt::StringLiterals;

/// Every screen, drawn: nothing is cut off at the edge, nothing stays empty, in every language and size.
/// With LDS_PICTURES set to a folder the pictures are left there to be looked at.
class TestPanelPictures : public PanelFixture {
    Q_OBJECT

private:
    static QImage draw(const DisplayContent& content, const QSize& size, double ratio = 1)
    {
        QImage image(size * ratio, QImage::Format_RGB32);
        image.setDevicePixelRatio(ratio);
        image.fill(Qt::magenta);
        QPainter painter(&image);
        emulator::paintDisplay(painter, QRectF(QPointF(), size), content);
        return image;
    }
    static bool isLit(QRgb pixel) { return qGray(pixel) > 40; }
    static int litPixels(const QImage& image, const QRect& area)
    {
        int lit = 0;
        for (int y = area.top(); y <= area.bottom(); ++y) {
            for (int x = area.left(); x <= area.right(); ++x)
                lit += isLit(image.pixel(x, y));
        }
        return lit;
    }
    /// A frame of half a dot around everything stays dark: what reaches it has been cut off.
    static bool isCutOff(const QImage& image)
    {
        const QRect all = image.rect();
        const int frame = std::max(1, image.width() / 256);
        return litPixels(image, all) != litPixels(image, all.adjusted(frame, frame, -frame, -frame));
    }

    QList<DisplayContent> screensOfMenu()
    {
        QList<DisplayContent> screens;
        for (const MenuEntry& entry : Catalog::hlG2().menu()) {
            goToMenu(entry.number);
            screens += shown();
            if (!entry.items.empty()) {
                tap(Key::Enter);
                screens += shown();
                const SettingItem& item = hlG2(entry.items.front());
                for (std::size_t i = 1; i < item.choices.size(); ++i) {
                    tap(Key::Down);
                    if (shown() != screens.last())
                        screens += shown();
                }
            }
            leaveMenus();
        }
        openMenu(31);
        enter(u"-6.0000"_s);
        screens += shown(); // with the error
        leaveMenus();
        return screens;
    }
    QList<DisplayContent> otherScreens()
    {
        QList<DisplayContent> screens{shown()};
        DisplayContent full = shown();
        full.icons = {true, true, true, true, true, true, u"B4"_s, u"PP"_s};
        for (const QString& body : {u"-950.00"_s, u"+OVER"_s, u"----"_s, u"ALARM"_s, u"E20007"_s}) {
            full.body = body;
            screens += full;
        }
        m_sensor->powerCycle();
        screens += shown();
        pass(2000);
        for (const Key key : {Key::Up, Key::Enter, Key::Down}) {
            tap(key);
            screens += shown();
            tap(key);
        }
        for (const Value mode : {1, 3}) {
            set(ItemId::TeachingMode, mode);
            holdLong(Key::Up);
            for (Value point = 0; point < mode; ++point) {
                screens += shown();
                place(point * 10'000);
                tap(Key::Enter);
            }
            screens += shown();
            pass(7000);
        }
        hold({Key::Up, Key::Down}, 2000);
        screens += shown();
        hold({Key::Up, Key::Down}, 2000);
        screens += shown();
        return screens;
    }
    void leavePictures(const QList<DisplayContent>& screens, const QString& name)
    {
        if (!qEnvironmentVariableIsSet("LDS_PICTURES"))
            return;
        constexpr int columns = 6;
        const QSize size(256, 128);
        const int rows = (int(screens.size()) + columns - 1) / columns;
        QImage sheet(columns * (size.width() + 8), rows * (size.height() + 8), QImage::Format_RGB32);
        sheet.fill(Qt::darkGray);
        QPainter painter(&sheet);
        for (qsizetype i = 0; i < screens.size(); ++i) {
            painter.drawImage(int(i % columns) * (size.width() + 8) + 4,
                              int(i / columns) * (size.height() + 8) + 4, draw(screens[i], size));
        }
        QVERIFY(sheet.save(QDir(qEnvironmentVariable("LDS_PICTURES")).filePath(name + u".png"_s)));
    }

private Q_SLOTS:
    void init() { setUp(); }

    void no_screen_is_cut_off_or_empty_data()
    {
        QTest::addColumn<int>("language");
        QTest::newRow("english") << 0;
        QTest::newRow("japanese") << 1;
        QTest::newRow("chinese") << 2;
    }
    void no_screen_is_cut_off_or_empty()
    {
        QFETCH(int, language);
        QVERIFY(set(ItemId::LanguageSetting, language));
        QVERIFY(!m_sensor->writeByKeys({{ItemId::LanguageSetting, language}}).refusal);
        const QList<DisplayContent> screens = otherScreens() + screensOfMenu();
        QVERIFY(screens.size() > 100);
        leavePictures(screens, QString::fromLatin1(QTest::currentDataTag()));
        for (const DisplayContent& content : screens) {
            for (const int width : {128, 256, 500}) {
                const QImage image = draw(content, {width, width / 2});
                const QByteArray what = (content.title + u" / "_s + content.body).toUtf8();
                QVERIFY2(litPixels(image, image.rect()) > width, what.constData());
                QVERIFY2(!isCutOff(image), what.constData());
            }
        }
    }

    /// §4.8.3
    void an_inverted_display_is_drawn_upside_down()
    {
        DisplayContent content = shown();
        const QImage upright = draw(content, {256, 128});
        content.inverted = true;
        const QImage inverted = draw(content, {256, 128}).mirrored(true, true);
        // Glyphs are smoothed differently when turned; the halves hold the same light.
        for (const QRect& area : {QRect(0, 0, 256, 28), QRect(0, 28, 256, 70), QRect(200, 98, 56, 30)}) {
            const int expected = litPixels(upright, area);
            QVERIFY(std::abs(litPixels(inverted, area) - expected) <= expected / 5 + 10);
        }
        QVERIFY(litPixels(upright, {0, 0, 256, 28}) > 4 * litPixels(upright, {60, 100, 130, 28}));
    }

    /// §4.8.2
    void a_dim_display_is_darker_and_a_dark_one_black()
    {
        DisplayContent content = shown();
        const auto brightest = [&content](Brightness brightness) {
            content.brightness = brightness;
            const QImage image = draw(content, {256, 128});
            int most = 0;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x)
                    most = std::max(most, qGray(image.pixel(x, y)));
            }
            return most;
        };
        QVERIFY(brightest(Brightness::Normal) > 200);
        QVERIFY(brightest(Brightness::Dim) < 120);
        QVERIFY(brightest(Brightness::Dim) > 50);
        QVERIFY(brightest(Brightness::Off) < 10);
        QVERIFY(brightest(Brightness::Blink) < 10);
    }

    /// On a screen with more pixels the glyphs have more pixels, they are not enlarged ones.
    void it_is_sharp_on_a_fine_screen()
    {
        const QImage coarse = draw(shown(), {256, 128});
        const QImage fine = draw(shown(), {256, 128}, 2);
        const QImage enlarged = coarse.scaled(fine.size());
        int different = 0;
        for (int y = 0; y < fine.height(); ++y) {
            for (int x = 0; x < fine.width(); ++x)
                different += isLit(fine.pixel(x, y)) != isLit(enlarged.pixel(x, y));
        }
        QVERIFY(different > 300);
    }

    void the_whole_panel_is_drawn()
    {
        emulator::PanelWidget widget;
        place(12'345);
        widget.showContent(shown());
        widget.resize(widget.sizeHint());
        const QImage image = widget.grab().toImage();
        QVERIFY(!image.isNull());
        if (qEnvironmentVariableIsSet("LDS_PICTURES"))
            QVERIFY(image.save(QDir(qEnvironmentVariable("LDS_PICTURES")).filePath(u"panel.png"_s)));
    }
};

QTEST_MAIN(TestPanelPictures)
#include "tst_panel_pictures.moc"
