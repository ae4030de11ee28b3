#include "banner.h"

#include "theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

namespace lds::ui {

namespace {

ColorRole inkOf(Banner::Kind kind)
{
    switch (kind) {
    case Banner::Kind::Warning:
        return ColorRole::Warning;
    case Banner::Kind::Error:
        return ColorRole::Error;
    case Banner::Kind::Information:
        break;
    }
    return ColorRole::Accent;
}

QString iconOf(Banner::Kind kind)
{
    switch (kind) {
    case Banner::Kind::Warning:
        return QStringLiteral("state-warning");
    case Banner::Kind::Error:
        return QStringLiteral("state-error");
    case Banner::Kind::Information:
        break;
    }
    return QStringLiteral("info");
}

} // namespace

Banner::Banner(QWidget* parent)
    : QFrame(parent)
    , m_icon(new QLabel(this))
    , m_text(new QLabel(this))
    , m_action(new QPushButton(this))
    , m_close(new QPushButton(this))
{
    m_text->setWordWrap(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_text->setObjectName(QStringLiteral("bannerText"));
    m_action->setObjectName(QStringLiteral("bannerAction"));
    m_action->hide();
    m_close->setProperty("quiet", true);
    m_close->setObjectName(QStringLiteral("bannerClose"));
    m_close->setAccessibleName(tr("Close this message"));
    m_close->setToolTip(tr("Close this message"));
    m_close->setFixedSize(28, 28);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 4, 4, 4);
    row->setSpacing(8);
    row->addWidget(m_icon, 0, Qt::AlignVCenter);
    row->addWidget(m_text, 1);
    row->addWidget(m_action, 0, Qt::AlignVCenter);
    row->addWidget(m_close, 0, Qt::AlignVCenter);
    connect(m_action, &QPushButton::clicked, this, &Banner::actionTriggered);
    connect(m_close, &QPushButton::clicked, this, &Banner::closed);
    connect(&Theme::instance(), &Theme::changed, this, &Banner::applyTheme);
    applyTheme();
}

void Banner::setMessage(Kind kind, const QString& text)
{
    m_kind = kind;
    m_text->setText(text);
    setAccessibleName(text);
    applyTheme();
}

QString Banner::text() const { return m_text->text(); }

void Banner::setAction(const QString& text)
{
    m_action->setText(text);
    m_action->setVisible(!text.isEmpty());
}

void Banner::setClosable(bool closable) { m_close->setVisible(closable); }

void Banner::applyTheme()
{
    m_icon->setPixmap(Theme::instance().icon(iconOf(m_kind), inkOf(m_kind)).pixmap(18, 18));
    m_close->setIcon(Theme::instance().icon(QStringLiteral("close")));
    update();
}

void Banner::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color(m_kind == Kind::Warning ? ColorRole::Edit
                           : m_kind == Kind::Error ? ColorRole::Panel
                                                   : ColorRole::AccentSoft));
    painter.drawRoundedRect(rect(), 4, 4);
    if (m_kind == Kind::Error) {
        painter.setPen(color(ColorRole::Error));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(color(m_kind == Kind::Warning ? ColorRole::EditBar : inkOf(m_kind)));
    painter.drawRoundedRect(QRectF(0, 0, 3, height()), 1.5, 1.5);
}

} // namespace lds::ui
